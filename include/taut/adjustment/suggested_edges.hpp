// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "taut/adjustment/plan.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// An edge that cannot be turned now, and what it would give if it were adjustable.
struct SuggestedEdge {
    int edge = 0;                    ///< index in the net
    double stroke = 0.0;             ///< of this edge then [m]
    double normal_rmse_after = 0.0;  ///< with this edge and those before it, all strokes free [m]
    /// The same of the target tensions, in their tolerances; empty without them [-].
    std::optional<double> tension_rmse_after = {};
};

/// Which edges would bring form and tensions nearest to their targets if they were made adjustable
/// or cut to another length, one after the other. Each time all edges are ranked to first order,
/// and of the first few the best is chosen in exact equilibrium, within the effective limits of the
/// plan. docs/theory.md (suggested-edges).
/// @param target, limits, options that the plan was made with
/// @param plan of this net; suggested strokes are at most the longest of the adjustable edges
/// @param count at most so many; fewer where no other edge lowers the cost by 0.1 %
/// @param progress gets the stage "suggested edges" before each and at the end
/// @throws std::invalid_argument for a count below 1, what plan_strokes() refuses, and a plan of
///   another net, other limits or other edges
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<SuggestedEdge> suggested_edges(
    const BuiltNet& built, const FormTarget& target, const Limits& limits,
    const PlanOptions& options, const Plan& plan, int count, const Progress& progress = {});

}  // namespace taut
