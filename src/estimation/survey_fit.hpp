// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/explanation.hpp"

namespace taut {

/// What a survey was found to say: form and lengths by maximum a posteriori under the statics,
/// (map) of docs/theory.md, with its slack set, gross errors rejected by data snooping, and the
/// covariance linearised at the result.
struct SurveyFit {
    LinearisedFit at;
    bool converged = false;  ///< lengths and form no longer moved
    double cost = 0.0;       ///< Explanation::cost; infinite where nothing converged
    bool contradicts_too_many =
        false;                  ///< more targets contradict the others than can have gross errors
    Hypotheses hypotheses;      ///< with their tests at the result
    PriorKnowledge knowledge;   ///< as given, with the priors of released edges widened
    Observations observations;  ///< the targets and force measurements in use and the prior
    double tolerance = 0.0;     ///< a step this small changes nothing that the survey shows [m]
    // Those found of each kind, the largest statistic first.
    std::vector<Outlier> outliers;
    std::vector<ForceOutlier> force_outliers;
    std::vector<LengthOutlier> length_outliers;
};

/// Fits form and lengths to a survey under the statics. Where explain() does not converge, it uses
/// rounded tension laws, from wide corners to narrow ones, and finally a continuation over the
/// noise. Where something is suspicious, it tries what else may explain it, and takes the fit of
/// the lowest cost.
/// @throws std::invalid_argument, SurveyError as FitProblem
/// @throws NumericalError where the statics are singular at what the search ended with
/// @throws Interrupted where a stop was requested
[[nodiscard]] SurveyFit fit_survey(const CableNet& net, const Survey& survey,
                                   const PriorKnowledge& knowledge,
                                   const SurveyFitSettings& settings = {});

}  // namespace taut
