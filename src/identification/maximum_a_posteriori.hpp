// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/survey_fit.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_law.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Maximum a posteriori under the statics: SurveyFit with the law as prior. Standard deviations are
/// those of the posterior linearised at the result (Laplace); the length of each edge then follows
/// from this and the law itself (posterior_of()). Of an exact survey of all nodes the lengths are
/// those of the balance.
/// @throws std::invalid_argument as SurveyFit
/// @throws std::runtime_error where the statics are singular at the surveyed form
[[nodiscard]] Identification identify_by_maximum_a_posteriori(
    const CableNet& net, const Survey& survey, const LengthLaw& law,
    const SurveyFitSettings& settings = {});

/// What a fit tells of the lengths, under the law.
[[nodiscard]] Identification identification_of(const CableNet& net, const Survey& survey,
                                               const LengthLaw& law, const SurveyFit& fit,
                                               const GaussNewtonResult& fitted);

}  // namespace taut
