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
/// is a lower bound of V at any form. At an elastic support b, which is a free node, a force g of
/// its spring takes part in the balance, g on the left, and D gains -g . r_0 - g' K^-1 g / 2. The
/// two are equal at equilibrium only. So V(r) - D(f) bounds how far V(r) is above the lowest
/// energy: a proof that does not rely on any solver. (Textbooks call -D the complementary energy.)
namespace taut {

/// Upper bound on how far the energy of a form is above the lowest energy.
struct EnergyCertificate {
    double energy = 0.0;                ///< V(r) [J]
    double complementary_energy = 0.0;  ///< D(f), of forces that balance [J]
    /// V(r) - D(f) >= 0 [J]. Summed edge by edge from nonnegative terms, so it is accurate far
    /// below the last digit of V.
    double duality_gap = 0.0;
    /// The gap over an elastic energy: the largest of that of the form, that of the forces, sum T^2
    /// l_0 / (2 EA), and that of strains of 1e-6, for nets that are almost slack [-].
    double relative_gap = 0.0;
};

/// The certificate of a form with the tensions of its edges. D bounds V only for forces in exact
/// balance. The tensions of a computed form balance except for small residual forces, so they are
/// first corrected: along and across the edges, by the least correction in the sense of the
/// complementary energy. Its cost is part of the gap. The imbalance that rounding errors leave,
/// some 1e-16 of the tensions, is not.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form coordinates of all nodes (3 x n) [m]
/// @throws std::invalid_argument for a net with struts, wrong sizes, unstressed lengths that are
///   not positive and finite, coordinates and forces that are not finite
[[nodiscard]] TAUT_CORE_EXPORT EnergyCertificate
energy_certificate(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                   const Eigen::Ref<const Points>& form);

/// The same with other forces, for example the dual variables of a conic solver. They are corrected
/// likewise.
/// @param edge_forces f of all edges (3 x m) [N]
/// @throws std::invalid_argument likewise
[[nodiscard]] TAUT_CORE_EXPORT EnergyCertificate energy_certificate(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form, const Eigen::Ref<const Points>& edge_forces);

}  // namespace taut
