// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/survey_fit.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "taut/estimation/detectable.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/estimation/prior_estimate.hpp"

namespace taut {

/// What a fit shows of noise, prior and frame.
struct FitDiagnostics {
    VarianceComponents scales;
    PriorCheck prior;
    FrameCheck frame;
    LoadCheck loads;
    std::optional<PriorEstimate> estimate;
    std::vector<bool> left_out;       ///< interior edges (m_I) that do not follow the prior
    Eigen::VectorXd adjustable_stds;  ///< prior std of adjustable edges as built, else 0 (m_I)
};

/// docs/theory.md, (components), (prior-check), (common-mean)
/// @param fit_net net_to_fit()
/// @param fitted of the fit
[[nodiscard]] FitDiagnostics diagnostics_of(const CableNet& net, const CableNet& fit_net,
                                            const Given& given, const SurveyFit& fit,
                                            LinearisedFit fitted);

/// The smallest errors that the survey would show, docs/theory.md, (detectable).
/// @param priors as given to the fit (m_I)
[[nodiscard]] DetectableErrors detectable_of(const CableNet& net, const CableNet& fit_net,
                                             const Survey& survey, const SurveyFit& fit,
                                             const std::vector<LengthPrior>& priors,
                                             const FitDiagnostics& shown);

}  // namespace taut
