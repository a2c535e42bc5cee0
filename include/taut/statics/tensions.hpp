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
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd tensions(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// Edges that are not longer than their unstressed length and carry no tension; ascending.
/// @throws std::invalid_argument as tensions()
[[nodiscard]] TAUT_CORE_EXPORT std::vector<int> slack_edges(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// Weights of tensions (m) whose sum is their mean over the cables; over all edges where all are
/// struts.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd mean_weights(const CableNet& net);

/// How much longer tension makes edges at the net's nodes, negative in compressed struts (m): of a
/// straight edge l - l_0, 0 where slack, of a cable that sags T l_0 / EA [m].
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd elastic_stretches(const CableNet& net);

/// elastic_stretches() of cables in the mean [m].
[[nodiscard]] TAUT_CORE_EXPORT double mean_stretch(const CableNet& net);

}  // namespace taut
