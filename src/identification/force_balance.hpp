// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Force balance: for a known form, h = 0 (eq. hq) is linear in 1/l_0, docs/theory.md (balance).
/// Without noise it is solved as it is. With noise the balance is off by H dr, H = dh/dr. Weighted
/// with the inverse of H Sigma H', at the form of the weighted solution itself, it is the maximum
/// of the likelihood over lengths and form, and the limit of (map) for a wide prior. It is computed
/// so, with gross errors rejected by the same data snooping. The prior enters the posterior of each
/// edge alone (posterior_of()), not the estimate of the others. Where noise hides much this
/// amplifies it, unlike maximum a posteriori, and the standard deviations show it.
/// @throws SurveyError where a free node was not surveyed; else as
///   identify_by_maximum_a_posteriori()
[[nodiscard]] TAUT_CORE_EXPORT Identification identify_by_force_balance(const CableNet& net,
                                                                        const Survey& survey,
                                                                        const LengthPrior& prior);

}  // namespace taut
