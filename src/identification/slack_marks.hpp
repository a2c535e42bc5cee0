// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/survey_fit.hpp"

namespace taut {

/// A fit, and the marks of slack and taut edges that the survey contradicts.
struct MarkedFit {
    SurveyFit fit;
    std::vector<int> contradicted_taut;
    std::vector<int> contradicted_slack;
};

/// fit_survey(); without all marks where the survey contradicts them.
[[nodiscard]] MarkedFit fit_with_marks(const CableNet& net, const Survey& survey,
                                       const PriorKnowledge& knowledge,
                                       const SurveyFitSettings& settings);

}  // namespace taut
