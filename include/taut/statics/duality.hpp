// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// The certificate of an equilibrium. The energy V(r) of statics/energy.hpp has a dual: for forces
/// f (3 x m) that the edges (s, t) exert along r_s - r_t, and that balance the loads at every free
/// node,
///
///     sum_(s,t) f - sum_(t,s) f = p_s                                                  (balance)
///
/// the complementary energy, with T = |f| and the reactions R_b = sum_(b,t) f - sum_(s,b) f at the
/// supports,
///
///     D(f) = sum_b R_b . r_b  -  sum_(s,t) ( T l_0 + T^2 l_0 / (2 EA) )
///
/// is a lower bound of V at any form, and the two are equal at equilibrium alone. So V(r) - D(f) is
/// never less than what r is above the lowest energy: a proof that needs no trust in any solver.
/// (Textbooks take the negative of D for the complementary energy.)
namespace taut {

/// How far the energy of a form is above the lowest one, at most.
struct EnergyCertificate {
    double energy = 0.0;                ///< V(r) [J]
    double complementary_energy = 0.0;  ///< D(f), of forces that balance [J]
    /// V(r) - D(f) >= 0 [J]. Summed edge by edge from terms that are never negative, so it is exact
    /// far below the last place of V.
    double duality_gap = 0.0;
    /// The gap over the elastic energy: of the form, or of the forces, sum T^2 l_0 / (2 EA), where
    /// that is more; in a net that is all but slack, over that of strains of 1e-6 [-].
    double relative_gap = 0.0;
};

/// The certificate of a form with the tensions that it gives its edges. At a form that a solver
/// found these balance but for the out-of-balance forces, and D bounds V only where balance holds
/// to the last; so they are first brought to balance by the smallest correction, in the sense of
/// the complementary energy, along and across the edges. What that costs is part of the gap; what
/// rounding errors leave of the imbalance, some 1e-16 of the tensions, is not.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form coordinates of all nodes (3 x n) [m]
/// @throws std::invalid_argument for wrong sizes, unstressed lengths that are not positive and
///   finite, coordinates and forces that are not finite
[[nodiscard]] TAUT_CORE_EXPORT EnergyCertificate
certify(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
        const Eigen::Ref<const Points>& form);

/// The same with forces from elsewhere, a conic solver's dual variables say, brought to balance
/// likewise.
/// @param edge_forces f of all edges (3 x m) [N]
/// @throws std::invalid_argument likewise
[[nodiscard]] TAUT_CORE_EXPORT EnergyCertificate
certify(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
        const Eigen::Ref<const Points>& form, const Eigen::Ref<const Points>& edge_forces);

}  // namespace taut
