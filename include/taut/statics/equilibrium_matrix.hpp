// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <span>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// The equilibrium matrix A of some edges at a form (3 n_I x edges.size()): with their tensions T,
/// A T are the forces that they exert at the free nodes. The column of edge (s, t) holds the unit
/// vector u = (r_s - r_t)/l in the rows of s, -u in those of t. Balance (eqs. hq, h) reads A T = p.
namespace taut {

/// A, of the given edges.
/// @param form coordinates of all nodes (3 x n) [m]
/// @param edges columns of A, in this order
/// @throws std::invalid_argument for a form of the wrong size or not finite, an edge that the net
///   does not have, and an edge of zero length
[[nodiscard]] TAUT_CORE_EXPORT Eigen::SparseMatrix<double> equilibrium_matrix(
    const CableNet& net, const Eigen::Ref<const Points>& form, std::span<const int> edges);

/// Rank of A over the taut edges, and what follows from it.
struct StressStates {
    int rank = 0;         ///< of A
    int self_stress = 0;  ///< independent states of self-stress: columns of A less rank
    int mechanisms = 0;   ///< independent inextensional mechanisms: 3 n_I less rank
};

/// The rank of A over the edges that are taut at a form (3 x n) [m]. Singular values below 1e-5
/// count as zero.
/// @throws std::invalid_argument for wrong sizes, unstressed lengths that are not positive and
///   finite, coordinates that are not finite
[[nodiscard]] TAUT_CORE_EXPORT StressStates
stress_states(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
              const Eigen::Ref<const Points>& form);

}  // namespace taut
