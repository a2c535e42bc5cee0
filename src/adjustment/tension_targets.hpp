// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/stroke_search.hpp"
#include "taut/adjustment/tension_target.hpp"

namespace taut {

/// The edges of a group.
/// @throws RequestError of this field, where the net does not have the group
[[nodiscard]] const std::vector<int>& edges_of_group(const CableNet& net, const std::string& group,
                                                     const char* field);

/// Target tensions by edge, ascending.
/// @throws RequestError for a group or edge that the net does not have, and two different targets
///   of an edge by groups or by its index
[[nodiscard]] std::vector<TensionTarget> tension_targets_of(const CableNet& net,
                                                            std::span<const GivenTension> given);

/// @throws RequestError for targets that are not positive, out of range, doubled, or outside the
///   limits of their edge
void check_tension_targets(const CableNet& net, std::span<const TensionTarget> targets,
                           const TensionLimits& limits);

/// Root of the mean square of the deviations of tensions from their targets, in tolerances; empty
/// where there are no targets.
/// @param forces at least one per edge [N]
[[nodiscard]] std::optional<double> tension_rmse(std::span<const TensionTarget> targets,
                                                 const Eigen::VectorXd& forces);

/// States that a plan compares with its target tensions.
struct TensionStates {
    const StrokedState* as_built = nullptr;
    const StrokedState* planned = nullptr;
    const StrokedState* unconstrained = nullptr;  ///< with unlimited strokes
    const StrokedState* of_any_form = nullptr;    ///< the same without regard to the form
    const DrawnStrokes* draws = nullptr;          ///< of `planned`; null: no samples
};

[[nodiscard]] std::vector<ReachedTension> reached_tensions(std::span<const TensionTarget> targets,
                                                           const TensionStates& states);

}  // namespace taut
