// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/length_trend.hpp"
#include "estimation/linearisation.hpp"
#include "taut/identification/result.hpp"

namespace taut {

/// Adds what the lengths have in common to the result of a fit without it: docs/theory.md,
/// (length-trend).
/// @param fit_net net_to_fit()
void take_up_trend(Identification& result, const LengthTrend& trend, const CableNet& fit_net);

/// Covariance of the lengths of some edges, scaled to the standard deviations of the result.
[[nodiscard]] LengthCovariance covariance_of(const std::vector<int>& edges, const CableNet& fit_net,
                                             const Linearisation& linearisation,
                                             const LengthTrend& trend,
                                             const Identification& result);

}  // namespace taut
