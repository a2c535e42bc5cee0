// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/hypotheses.hpp"
#include "estimation/length_posterior.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Reports what data snooping found at the end of a search.
/// @param outliers of the targets, the largest statistic first
/// @param contradicts_too_many of the targets: sets the status
void set_snooping(Identification& result, const Survey& survey, const Hypotheses& hypotheses,
                  std::vector<Outlier> outliers, bool contradicts_too_many);

/// Fills the edges of a result from their likelihoods and priors (m_I), docs/theory.md (posterior).
void set_edges(Identification& result, const CableNet& net, const std::vector<LengthPrior>& priors,
               const std::vector<LengthLikelihood>& likelihoods);

/// Predicts the form from a result's lengths and uncertain parameters, beginning at a start, and
/// compares it with the survey. Status and message report where there is no equilibrium.
/// @param test_loads of the survey, among the net's loads (3 x n); 3 x 0: none [N]
void predict_form(Identification& result, const CableNet& net, const Survey& survey,
                  const Points& start, const Points& test_loads = Points(3, 0));

}  // namespace taut
