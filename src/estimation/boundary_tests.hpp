// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/hypotheses.hpp"
#include "estimation/linearisation.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Another length of each adjustable edge than given, and another place of each support.
/// @param false_alarm_rate of all these tests together; 0: no test
[[nodiscard]] std::vector<Hypothesis> boundary_hypotheses(const CableNet& net,
                                                          double false_alarm_rate);

/// Tests each of them at a fit, by the score statistic of it as a free parameter, docs/theory.md
/// (boundary); of a released one, of which the survey alone determines the length or place, the
/// estimate.
void test_boundary(Hypotheses& hypotheses, const Linearisation& linearisation,
                   const Covariance& covariance, const Iterate& fitted,
                   const Observations& observations);

/// The adjustable edges and supports to fit with as free.
[[nodiscard]] BoundaryReleases boundary_releases(const Hypotheses& hypotheses);

/// The same with their estimates, the largest statistic first.
[[nodiscard]] std::vector<BoundaryOutlier> boundary_outliers(const Hypotheses& hypotheses);

}  // namespace taut
