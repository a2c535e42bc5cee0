// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/epoch_evidence.hpp"
#include "estimation/hyperprior.hpp"
#include "estimation/survey_fit.hpp"
#include "identification/draw_posterior.hpp"
#include "taut/export/core.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// All that is given besides net and survey.
struct Given {
    LengthPrior prior;  ///< of the length deviations
    std::vector<UncertainParameter> uncertain;
    Forces forces;
    /// Standard deviations of edges (m) with a normal prior of their own: adjustable ones where
    /// uncertain, and others where not 0; empty: adjustable_stds() [m].
    Eigen::VectorXd own_stds;
    /// Distribution over priors, to estimate their posterior; empty: the prior is exact.
    std::optional<Hyperprior> hyperprior;
    /// Whether lengths may have a mean and scales in common, (length-trend).
    bool has_trend = false;
    /// Prior standard deviation of adjustable edges before any was turned, for (length-trend);
    /// empty: by `uncertain` [m].
    std::optional<double> unturned_std;
    Points test_loads = Points(3, 0);  ///< of the survey, among the loads of the net [N]
    /// Of other surveys of the same net to fit; null: none.
    std::shared_ptr<const LengthEvidence> evidence;

    // NOLINTNEXTLINE(google-explicit-constructor)
    Given(const LengthPrior& of_lengths, std::vector<UncertainParameter> parameters = {},
          Forces measured = {})
        : prior(of_lengths), uncertain(std::move(parameters)), forces(std::move(measured)) {}
};

/// Maximum a posteriori under the statics: fit_survey(), then the posterior mean by
/// propagate_prior(). Standard deviations are those of the posterior linearised at the result
/// (Laplace), cut by the prior itself (posterior_of()). An exact survey of all nodes is identified
/// by the balance, unless more than lengths is uncertain or forces are given.
/// @throws std::invalid_argument as fit_survey(), check_uncertain_parameters()
/// @throws std::runtime_error where the statics are singular at the surveyed form
[[nodiscard]] TAUT_CORE_EXPORT Identification identify_by_maximum_a_posteriori(
    const CableNet& net, const Survey& survey, const Given& given,
    const SurveyFitSettings& settings = {}, const PosteriorSettings& wanted = {},
    const Progress& progress = {});

/// The same without draws, and the evidence of the survey alone; none where the fit does not
/// converge.
struct IdentifiedEpoch {
    Identification identification;
    LengthEvidence own;
};
[[nodiscard]] TAUT_CORE_EXPORT IdentifiedEpoch identify_one_epoch(const CableNet& net,
                                                                  const Survey& survey,
                                                                  const Given& given,
                                                                  int common_count,
                                                                  const Progress& progress = {});

/// The lengths by a fit, under the prior; without a predicted form.
/// @param fit_net net_to_fit()
/// @param observations of the fit
[[nodiscard]] TAUT_CORE_EXPORT Identification
identification_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                  const LengthPrior& prior, const PriorKnowledge& knowledge, const SurveyFit& fit,
                  const LinearisedFit& fitted, const Observations& observations);

}  // namespace taut
