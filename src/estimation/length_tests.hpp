// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/hypotheses.hpp"
#include "estimation/length_posterior.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Another length of each interior edge than its prior allows, and of each pair of edges at a free
/// node of which one may be as much longer as the other is shorter: a cable may slip between two of
/// one run, and any two may have been swapped.
/// @param priors of the interior edges (m_I)
/// @param false_alarm_rate of all tests of one edge together, and of all of two; 0: no test
[[nodiscard]] std::vector<Hypothesis> length_hypotheses(const CableNet& net,
                                                        const std::vector<LengthPrior>& priors,
                                                        double false_alarm_rate);

/// Tests each of them at a fit: the prior of an edge's length is tested like a target, against the
/// length that survey and statics give without it, docs/theory.md (length-snooping), (slip).
/// @param likelihoods of each interior edge's length, without its prior (m_I)
void test_lengths(Hypotheses& hypotheses, const CableNet& net,
                  const std::vector<LengthPrior>& priors,
                  const std::vector<LengthLikelihood>& likelihoods,
                  const Linearisation& linearisation, const Observations& observations,
                  const Iterate& fitted);

/// Whether one edge of a pair is as much longer as the other is shorter, within what a fit shows.
[[nodiscard]] bool is_slip(const Hypothesis& pair, const std::vector<LengthPrior>& priors);

/// The priors to fit with: those of released edges are normal and too wide to matter (m_I).
[[nodiscard]] std::vector<LengthPrior> priors_with_released(const Hypotheses& hypotheses,
                                                            const CableNet& net,
                                                            const std::vector<LengthPrior>& priors);

/// DetectableErrors::length, for those of these edges that are in use at the fit.
[[nodiscard]] double detectable_length(const Hypotheses& hypotheses, const CableNet& net,
                                       const std::vector<LengthPrior>& priors,
                                       const std::vector<int>& edges);

/// The released edges, the largest statistic first.
[[nodiscard]] std::vector<LengthOutlier> length_outliers(const Hypotheses& hypotheses,
                                                         const CableNet& net,
                                                         const std::vector<LengthPrior>& priors);

}  // namespace taut
