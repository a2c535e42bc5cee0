// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/identification.hpp"
#include "taut/sampling/length_law.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

struct MaximumAPosterioriSettings {
    int max_iterations = 50;                             ///< Gauss-Newton steps of each search
    double false_alarm_rate = default_false_alarm_rate;  ///< 0: no test
};

/// Maximum a posteriori under the statics. Over lengths and form together, minimises
///
///   1/2 sum ((r - r_measured) / noise_std)^2 + 1/2 sum (dl_0 / law.std())^2
///
/// over the surveyed coordinates and the interior edges, subject to equilibrium, h(r, l_0) = 0
/// (eq. h), by Gauss-Newton steps on the sparse conditions of optimality. Standard deviations are
/// those of the posterior linearised at the result (Laplace), from the inverse of the same matrix;
/// the length of each edge then follows from this and the law itself (posterior_of()). Any subset
/// of coordinates may be surveyed, with any noise. Gross errors are looked for, and the targets
/// that have them left out: by data snooping (Baarda), three coordinates of a target at a time,
/// each against a chi-squared quantile, until no target in use contradicts the others and none left
/// out agrees with them. Not where all coordinates are exact. Edges begin as slack that were
/// measured shorter than they can be while taut, by more than three standard deviations; then the
/// fitted form tells. A search that does not settle, or leaves out too many targets, begins anew as
/// if the noise were so large that nothing is a gross error, then ever smaller.
///
/// An exact coordinate (noise 0) is taken to be so to 1e-7 of the net's mean edge length: standard
/// deviations are of that order, and larger than the errors, which are those of rounding. Where all
/// nodes were surveyed so, the lengths are those of the balance: see identify_by_force_balance().
///
/// @throws std::invalid_argument for a survey of another size, an index that is not a free node's
/// or
///   comes twice, noise that is negative or not finite, a position that is not, no surveyed node
/// @throws std::runtime_error where the identified lengths find no equilibrium, or an exact form
///   balances with no positive length of an edge
[[nodiscard]] Identification identify_by_maximum_a_posteriori(
    const CableNet& net, const Survey& survey, const LengthLaw& law,
    const MaximumAPosterioriSettings& settings = {});

}  // namespace taut
