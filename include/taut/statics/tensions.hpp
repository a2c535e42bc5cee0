// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/net/cable_net.hpp"

/// All three throw std::invalid_argument for wrong sizes, unstressed lengths that are not positive
/// and finite, and coordinates that are not finite.
namespace taut {

/// Lengths l_(s,t) = |r_s - r_t| of all edges (m) at a form (3 x n) [m].
[[nodiscard]] Eigen::VectorXd edge_lengths(const CableNet& net,
                                           const Eigen::Ref<const Points>& form);

/// Tensions EA max(0, l / l_0 - 1) of all edges (m) at a form (3 x n) [N].
[[nodiscard]] Eigen::VectorXd tensions(const CableNet& net,
                                       const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                       const Eigen::Ref<const Points>& form);

/// Edges that are no longer than their unstressed length, and so carry no tension; ascending.
[[nodiscard]] std::vector<int> slack_edges(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

}  // namespace taut
