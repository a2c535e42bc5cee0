// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/adjustment/limits.hpp"

namespace taut {

/// A limit exceeded by less than this part of the mean tension is kept: equilibria are no more
/// exact.
inline constexpr double negligible_violation = 1e-5;

/// The nodes of all reaction limits, in their order.
[[nodiscard]] std::vector<int> supports_of(const std::vector<ReactionLimit>& reactions);

/// Least tension of an edge that must stay taut: twice the negligible violation [N].
/// @param net its nodes in equilibrium, or near it
[[nodiscard]] double least_taut(const CableNet& net);

/// Limits of all tensions, then of the reactions. A least tension of 0 means taut: least_taut().
[[nodiscard]] ForceRange range_of(const CableNet& net, const TensionLimits& tension,
                                  const std::vector<ReactionLimit>& reactions);

/// What a row of StrokedNet::forces carries: nothing where a cable would be pressed.
[[nodiscard]] double carried(const CableNet& net, Eigen::Index row, double force);
/// The same of all edges (m) [N].
[[nodiscard]] Eigen::VectorXd carried_tensions(const CableNet& net, const Eigen::VectorXd& forces);

/// A limit of range_of() as it was given.
[[nodiscard]] double given_limit(const CableNet& net, double limit);

/// The net with other loads.
[[nodiscard]] CableNet with_loads(const CableNet& net, const Points& loads);

}  // namespace taut
