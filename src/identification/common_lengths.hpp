// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/length_trend.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/result.hpp"

namespace taut {

/// Adds what the lengths have in common to the result of a fit without it: docs/theory.md,
/// (length-trend).
void take_up_trend(Identification& result, const LengthTrend& trend,
                   const PriorKnowledge& knowledge, const LinearisedFit& fitted);

/// Covariance of the lengths of some edges, scaled to the standard deviations of the result.
/// @param sites observations of the fit
[[nodiscard]] LengthCovariance covariance_of(const std::vector<int>& edges,
                                             const LinearisedFit& fitted, const Observations& sites,
                                             const LengthTrend& trend,
                                             const Identification& result);

}  // namespace taut
