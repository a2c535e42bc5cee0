// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/adjustment/plan.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// An edge that may not be turned, and what it would give if it could, beside those before it.
struct FurtherEdge {
    int edge = 0;                    ///< index in the net
    double stroke = 0.0;             ///< of it then [m]
    double normal_rmse_after = 0.0;  ///< of the form, all strokes free [m]
};

/// Which further edges, made adjustable or cut to another length, would bring the form nearest to
/// the target, one after the other. Each time the edges are ranked by what they would give to first
/// order, (further-edges), and of the first few the best is taken by a search in exact equilibrium,
/// within the limits that the plan held for the estimate. docs/theory.md (further-edges).
/// @param target, limits, options as the plan was made with
/// @param plan of this net; strokes of further edges go as far as the longest of those that may be
///   turned
/// @param count how many at most; fewer where no other edge would help, by 0.1 % of the cost
/// @throws std::invalid_argument for a count below 1, what plan_strokes() refuses, and a plan of
///   another net, other limits or other edges
/// @param progress told of the stage "further edges" before each and at the end
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<FurtherEdge> further_edges(
    const BuiltNet& built, const FormTarget& target, const Limits& limits,
    const PlanOptions& options, const Plan& plan, int count, const Progress& progress = {});

}  // namespace taut
