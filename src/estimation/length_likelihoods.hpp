// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/length_posterior.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"

namespace taut {

/// An edge with this extension, in its standard deviations, is surely taut.
inline constexpr double surely_taut_extension = 4.0;

/// The likelihood of each interior edge's length (m_I): the fit without the prior of that length.
/// docs/theory.md, (likelihood)
/// @param observations with the prior that the fit was made with
/// @param covariance of the fit
[[nodiscard]] std::vector<LengthLikelihood> length_likelihoods(const PriorKnowledge& knowledge,
                                                               const StaticsModel& model,
                                                               const Covariance& covariance,
                                                               const Observations& observations,
                                                               const Iterate& fitted);

}  // namespace taut
