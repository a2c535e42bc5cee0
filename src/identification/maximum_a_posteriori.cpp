// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/maximum_a_posteriori.hpp"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "estimation/expectation_propagation.hpp"
#include "estimation/length_likelihoods.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The likely reason, and what would help.
std::string why_unsettled(const CableNet& net, const Survey& survey, const LengthLaw& law) {
    const double stretch =
        (edge_lengths(net, net.nodes()) - net.unstressed_lengths()).cwiseMax(0.0).mean();
    std::string text = "found no lengths that settle: iteration limit; ";
    if (stretch < law.std()) {
        text += fmt::format(
            "the cables stretch by {:.2g} mm in the mean and their lengths deviate by {:.2g} mm, "
            "so "
            "that any of them may be slack: a narrower --law would help, if it is true",
            1e3 * stretch, 1e3 * law.std());
    } else {
        text += "are net, loads, frame and noise right";
    }
    if (!survey.is_whole()) {
        text += fmt::format("; a survey of the {} missing nodes would help", survey.missing.size());
    }
    return text;
}

}  // namespace

Identification identify_by_maximum_a_posteriori(const CableNet& net, const Survey& survey,
                                                const LengthLaw& law,
                                                const SurveyFitSettings& settings,
                                                const DrawSettings& draws,
                                                const Progress& progress) {
    check_survey(net, survey);
    Identification result;
    if (survey.is_exact() && survey.is_whole()) {
        result = identify_by_exact_balance(net, survey, law);
    } else {
        SurveyFit fit(net, survey, law, settings);  // (map), (slack-set), (snooping)
        GaussNewtonResult fitted = fit.run();
        Observations observations = fit.observations();
        if (fitted.converged) {
            Propagated settled = propagate_law(net, law, fit.statics(), observations,
                                               fitted.iterate, fit.tolerance());
            fitted.iterate = std::move(settled.iterate);
            observations = std::move(settled.observations);
        }
        result = identification_of(net, survey, law, fit, fitted, observations);
        draw_posterior(result, net, survey, law, fit.statics(), observations, fitted.iterate, draws,
                       progress);
        predict_form(result, net, survey, fitted.iterate.form);
    }
    result.method = "map";
    return result;
}

Identification identification_of(const CableNet& net, const Survey& survey, const LengthLaw& law,
                                 const SurveyFit& fit, const GaussNewtonResult& fitted,
                                 const Observations& observations) {
    Identification result;
    if (!fitted.converged) {
        result.status = IdentificationStatus::iteration_limit;
        result.message = why_unsettled(net, survey, law);
    }
    tell_snooping(result, survey, fit.snooping(), fit.contradicts_too_many());
    tell_edges(result, net, law,
               length_likelihoods(net, fit.statics(), observations,
                                  fitted.iterate));  // (covariance), (likelihood), (posterior)
    return result;
}

}  // namespace taut
