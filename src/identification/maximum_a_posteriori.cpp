// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/maximum_a_posteriori.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "estimation/expectation_propagation.hpp"
#include "estimation/length_likelihoods.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/unknown_estimates.hpp"
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

/// What was told of forces, and what all else says to it.
void tell_forces(Identification& result, const CableNet& fit_net, const PriorKnowledge& knowledge,
                 const SurveyFit& fit, const Iterate& fitted) {
    constexpr double beyond_chance = 4.0;  // standard deviations
    const Forces& forces = knowledge.forces;
    result.readings = static_cast<int>(forces.readings.size());
    result.reading_outliers = fit.snooping().reading_outliers();
    const Eigen::VectorXd tensions = fit.statics().tensions(fitted);
    const Eigen::VectorXd variances = fit.statics().tension_variances();
    for (const int edge : forces.taut) {
        if (tensions(edge) < -beyond_chance * std::sqrt(std::max(0.0, variances(edge)))) {
            result.contradicted_taut.push_back(edge);
        }
    }
    const Eigen::VectorXd lengths = edge_lengths(fit_net, fitted.form);
    for (const int edge : forces.slack) {
        const auto interior = std::ranges::lower_bound(fit_net.interior_edges(), edge);
        const bool is_interior = interior != fit_net.interior_edges().end() && *interior == edge;
        const double longest =
            fit_net.unstressed_lengths()(edge) +
            (is_interior
                 ? beyond_chance * knowledge.laws[interior - fit_net.interior_edges().begin()].std()
                 : 0.0);
        const double noise =
            std::sqrt(fit.statics().form_covariance(fit_net.free_nodes()[0]).trace());
        if (lengths(edge) > longest + beyond_chance * noise) {
            result.contradicted_slack.push_back(edge);
        }
    }
}

}  // namespace

Identification identify_by_maximum_a_posteriori(const CableNet& net, const Survey& survey,
                                                const Told& told, const SurveyFitSettings& settings,
                                                const DrawSettings& draws,
                                                const Progress& progress) {
    check_survey(net, survey);
    check_unknowns(net, told.unknowns);
    Identification result;
    const bool only_lengths = told.unknowns.empty() && told.forces.empty();
    if (survey.is_exact() && survey.is_whole() && only_lengths) {
        result = identify_by_exact_balance(net, survey, told.law);
        result.method = "map";
        return result;
    }
    const CableNet fit_net = net_to_fit(net, told.unknowns);
    const PriorKnowledge knowledge =
        knowledge_of(net, fit_net, told.law, told.unknowns, told.forces);
    SurveyFit fit(fit_net, survey, knowledge, settings);  // (map), (slack-set), (snooping)
    GaussNewtonResult fitted = fit.run();
    Identification before_law;
    tell_forces(before_law, fit_net, knowledge, fit, fitted.iterate);
    Observations observations = fit.observations();
    if (fitted.converged) {
        Propagated settled = propagate_law(fit_net, knowledge, fit.statics(), observations,
                                           fitted.iterate, fit.tolerance());
        fitted.iterate = std::move(settled.iterate);
        observations = std::move(settled.observations);
    }
    result =
        identification_of(net, fit_net, survey, told.law, knowledge, fit, fitted, observations);
    result.readings = before_law.readings;
    result.reading_outliers = before_law.reading_outliers;
    result.contradicted_taut = before_law.contradicted_taut;
    result.contradicted_slack = before_law.contradicted_slack;
    result.unknowns =
        unknown_estimates(net, knowledge, fit.statics(), observations, fitted.iterate);
    if (!fit_net.is_linear()) {
        fit.statics().hold_laws(fitted.iterate);  // (drawn-law)
    }
    draw_posterior(result, net, fit_net, survey, told.law, knowledge, fit.statics(), observations,
                   fitted.iterate, draws, progress);
    predict_form(result, net, survey, fitted.iterate.form);
    result.method = "map";
    return result;
}

Identification identification_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                                 const LengthLaw& law, const PriorKnowledge& knowledge,
                                 const SurveyFit& fit, const GaussNewtonResult& fitted,
                                 const Observations& observations) {
    Identification result;
    if (!fitted.converged) {
        result.status = IdentificationStatus::iteration_limit;
        result.message = why_unsettled(net, survey, law);
    }
    tell_snooping(result, survey, fit.snooping(), fit.contradicts_too_many());
    std::vector<LengthLikelihood> likelihoods =
        length_likelihoods(fit_net, knowledge, fit.statics(), observations,
                           fitted.iterate);  // (covariance), (likelihood), (posterior)
    if (fit_net.interior_edge_count() > net.interior_edge_count()) {
        std::vector<LengthLikelihood> interior;
        for (const int edge : net.interior_edges()) {
            interior.push_back(likelihoods[edge]);
        }
        likelihoods = std::move(interior);
    }
    tell_edges(result, net, law, likelihoods);
    for (IdentifiedEdge& edge : result.edges) {
        // Seen, where the form leaves next to no length of the law for it.
        if (std::ranges::find(knowledge.forces.slack, edge.edge) != knowledge.forces.slack.end()) {
            edge.status = EdgeStatus::slack;
        }
    }
    return result;
}

}  // namespace taut
