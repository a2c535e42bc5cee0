// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
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

/// What is told besides net and survey.
struct Given {
    LengthPrior prior;  ///< of the length deviations
    std::vector<UncertainParameter> uncertain;
    Forces forces;
    /// Of edges (m) whose lengths follow a normal prior of their own: adjustable ones, where these
    /// are unknown, and others where it is not 0; empty: adjustable ones as the uncertain tell [m].
    Eigen::VectorXd own_stds;
    /// Over priors, of which the result then tells the posterior; empty: the prior is exact.
    std::optional<Hyperprior> hyperprior;
    /// Whether lengths may have a mean and scales in common, (length-trend).
    bool has_trend = false;
    /// Of other surveys of the same net to fit; null: there is none.
    std::shared_ptr<const LengthEvidence> evidence;

    /// The prior, and nothing else.
    Given(const LengthPrior& with_prior)
        : prior(with_prior) {}  // NOLINT(google-explicit-constructor)
};

/// Maximum a posteriori under the statics: SurveyFit with the prior as prior, then the posterior
/// mean, by propagate_prior(). Standard deviations are those of the posterior linearised at the
/// result (Laplace), as the prior itself cuts it (posterior_of()). Of an exact survey of all nodes
/// the lengths are those of the balance, unless more than them is unknown, or forces are told.
/// @throws std::invalid_argument as SurveyFit, check_uncertain_parameters()
/// @throws std::runtime_error where the statics are singular at the surveyed form
[[nodiscard]] TAUT_CORE_EXPORT Identification identify_by_maximum_a_posteriori(
    const CableNet& net, const Survey& survey, const Given& told,
    const SurveyFitSettings& settings = {}, const PosteriorSettings& wanted = {},
    const Progress& progress = {});

/// The same, without draws, and what the survey tells of the lengths by itself; nothing where the
/// fit does not converge.
struct IdentifiedEpoch {
    Identification identification;
    LengthEvidence own;
};
[[nodiscard]] TAUT_CORE_EXPORT IdentifiedEpoch identify_one_epoch(const CableNet& net,
                                                                  const Survey& survey,
                                                                  const Given& told,
                                                                  int common_count,
                                                                  const Progress& progress = {});

/// What a fit tells of the lengths, under the prior; no form is predicted yet.
/// @param fit_net of the fit, net_to_fit()
/// @param observations with the prior that the fit was made with
[[nodiscard]] TAUT_CORE_EXPORT Identification
identification_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                  const LengthPrior& prior, const PriorKnowledge& knowledge, const SurveyFit& fit,
                  const GaussNewtonResult& fitted, const Observations& observations);

}  // namespace taut
