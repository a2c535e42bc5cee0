// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearised_statics.hpp"
#include "taut/estimation/length_posterior.hpp"
#include "taut/identification/identification.hpp"

namespace taut {

/// What the fit tells of each interior edge (m_I), without what was known of its length before.
/// @param fitted form and lengths under the statics, linearised and inverted there
[[nodiscard]] std::vector<LengthLikelihood> likelihoods(const CableNet& net,
                                                        const ConditionedStatics& statics,
                                                        const Knowledge& knowledge,
                                                        const Guess& fitted);

/// Fills the edges from their likelihoods (m_I) and the law, then solves the equilibrium with their
/// lengths, and compares its form with the survey.
/// @throws std::runtime_error where there is no equilibrium
void complete(Identification& result, const CableNet& net, const Survey& survey,
              const LengthLaw& law, const std::vector<LengthLikelihood>& likelihoods,
              const Points& start);

/// Predicts the form from length deviations (m_I) [m], from a start, and compares it with the
/// survey.
/// @throws std::runtime_error where the lengths find no equilibrium
void predict_form(Identification& result, const CableNet& net, const Survey& survey,
                  const Eigen::VectorXd& deviations, const Points& start);

}  // namespace taut
