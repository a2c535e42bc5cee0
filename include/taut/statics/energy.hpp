// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// The energy of a net with tension-only linear elastic edges, and its first two derivatives with
/// respect to the coordinates of the free nodes. The three take the same arguments: the net (n
/// nodes, m edges, n_I free nodes), the unstressed lengths l_0 of all edges (m) [m], and the form,
/// coordinates of all nodes (3 x n) [m]. With l = |r_s - r_t| and the loads p:
///
///     V(r) = sum_(s,t) EA / (2 l_0) max(0, l - l_0)^2  -  sum_s p_s . r_s
///
/// and of each elastic support b, with its stiffness K and its place r_0 without load,
///
///     + 1/2 (r_b - r_0)' K (r_b - r_0)
///
/// V is convex in r, and once continuously differentiable.
namespace taut {

/// V [J], elastic energy less the work of the loads: half the objective v of the paper's SOCP if no
/// load acts.
/// @throws std::invalid_argument for wrong sizes, unstressed lengths that are not positive and
///   finite, and coordinates that are not finite
[[nodiscard]] TAUT_CORE_EXPORT double potential_energy(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// Forces of a form (3 x n) on the springs of the elastic supports, K (r_b - r_0); 0 at other nodes
/// (3 x n) [N].
[[nodiscard]] TAUT_CORE_EXPORT Points elastic_forces(const CableNet& net,
                                                     const Eigen::Ref<const Points>& form);

/// The net with the places of its elastic supports such that these are in balance at its nodes and
/// lengths: r_0 = r_b + K^-1 h, with h the force by edges and loads. For a frame that was built so
/// that the net stands in its nominal form.
[[nodiscard]] TAUT_CORE_EXPORT CableNet with_supports_in_balance(const CableNet& net);

/// dV/dr_I (3 n_I) [N]: the force balances h_s of the paper (eqs. hq, h) less the loads,
///
///     h_s = sum_(s,t) EA (r_s - r_t) (1/l_0 - 1/l) - p_s   over the edges with l > l_0
///
/// and K (r_b - r_0) more at an elastic support.
/// @throws std::invalid_argument as potential_energy()
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd out_of_balance_forces(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

/// d2V/dr_I2, symmetric (3 n_I x 3 n_I, both triangles) [N/m]. With u = (r_s - r_t)/l and the
/// tension T = EA (l/l_0 - 1), a taut edge adds
///
///     k = EA/l_0 u u' + T/l (I - u u')
///
/// to the blocks (s,s) and (t,t) and -k to (s,t) and (t,s); a slack edge adds nothing. An elastic
/// support adds K to (b,b).
/// @throws std::invalid_argument as potential_energy()
[[nodiscard]] TAUT_CORE_EXPORT Eigen::SparseMatrix<double> tangent_stiffness(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

}  // namespace taut
