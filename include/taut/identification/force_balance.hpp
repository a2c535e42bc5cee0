// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/identification.hpp"
#include "taut/sampling/length_law.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Force balance: for a known form, h = 0 (eq. hq) is linear in 1/l_0,
///
///   sum_(s,t) EA (r_s - r_t) (1/l_0 - 1/l) = p_s   at every free node s,
///
/// with 1/l_0 of the interior edges unknown, and of the adjustable ones known. Without noise these
/// equations are solved as they are, by sparse least squares: exact. With noise they are
/// off by H dr, H = dh/dr, so their errors have the covariance H Sigma H': weighted with its
/// inverse, at the form that the weighted solution tells itself, this is the maximum of the
/// likelihood over lengths and form. The law enters the posterior of each edge alone
/// (posterior_of()), not the estimate of the others: where noise hides much, as maximum a
/// posteriori does not, this amplifies it, and the standard deviations say so.
///
/// An exact coordinate (noise 0) is taken to be so to 1e-7 of the net's mean edge length.
///
/// @throws std::invalid_argument as identify_by_maximum_a_posteriori(), and where a free node was
///   not surveyed
/// @throws std::runtime_error where the balance asks for a length that is not positive, or the
///   identified lengths find no equilibrium
[[nodiscard]] Identification identify_by_force_balance(const CableNet& net, const Survey& survey,
                                                       const LengthLaw& law);

}  // namespace taut
