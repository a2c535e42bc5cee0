// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Lengths l_(s,t) = |r_s - r_t| of all edges (m) at a form (3 x n) [m].
/// @throws std::invalid_argument for a form of the wrong size, or not finite
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd edge_lengths(const CableNet& net,
                                                            const Eigen::Ref<const Points>& form);

/// Tensions of all edges (m) at a form (3 x n): EA max(0, l / l_0 - 1), or the tension law [N].
/// @throws std::invalid_argument for wrong sizes, unstressed lengths that are not positive and
///   finite, and coordinates that are not finite
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd tensions_of(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// Edges that are not longer than their unstressed length and carry no tension; ascending.
/// @throws std::invalid_argument as tensions_of()
[[nodiscard]] TAUT_CORE_EXPORT std::vector<int> slack_edges(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// Weights of tensions (m) whose sum is their mean over the cables; over all edges where all are
/// struts.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd mean_weights(const CableNet& net);

}  // namespace taut
