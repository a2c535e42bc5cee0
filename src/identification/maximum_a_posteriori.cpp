// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/maximum_a_posteriori.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimation/boundary_tests.hpp"
#include "estimation/expectation_propagation.hpp"
#include "estimation/gauss_newton.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/length_tests.hpp"
#include "estimation/length_trend.hpp"
#include "estimation/load_check.hpp"
#include "estimation/marginal_mode.hpp"
#include "estimation/target_tests.hpp"
#include "identification/common_lengths.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/fit_diagnostics.hpp"
#include "identification/parameter_estimates.hpp"
#include "identification/slack_marks.hpp"
#include "identification/stretch_lengths.hpp"
#include "statics/elastic_stretch.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The likely reason, and what would help.
std::string why_not_converged(const CableNet& net, const Survey& survey, const LengthPrior& prior) {
    const double stretch = mean_stretch(net);
    std::string text = "The fit did not converge within its iteration limit. ";
    if (stretch < prior.std_dev()) {
        text += fmt::format(
            "The mean stretch of the cables is {:.2g} mm and the prior of their lengths +-{:.2g} "
            "mm, so any of them may be slack. A narrower prior would help, if it is true.",
            1e3 * stretch, 1e3 * prior.std_dev());
    } else {
        text += "Check net, loads, frame and noise.";
    }
    if (!survey.is_whole()) {
        text += fmt::format(" A survey of the {} missing nodes would help.", survey.missing.size());
    }
    return text;
}

/// (frame)
FrameOffset frame_offset_of(const LinearisedFit& fitted) {
    const CommonParameters& common = fitted.model().common;
    const int first = common.first_of_frame();
    const Eigen::Matrix<double, 6, 1> values = fitted.iterate.common.segment<6>(first);
    const Eigen::Matrix<double, 6, 1> stds =
        fitted.covariance.common.diagonal().segment<6>(first).cwiseMax(0.0).cwiseSqrt();
    return {.about = common.frame_middle(),
            .translation = common.translation_unit() * values.head<3>(),
            .translation_std = common.translation_unit() * stds.head<3>(),
            .rotation = common.rotation_unit() * values.tail<3>(),
            .rotation_std = common.rotation_unit() * stds.tail<3>()};
}

/// Interior edges of the net to fit that are slack or may be: their likelihood is not normal. An
/// adjustable edge only where it is slack: its turns determine it better than a form that is fitted
/// without them.
std::vector<Eigen::Index> edges_maybe_slack(const CableNet& net, const CableNet& fit_net,
                                            const LinearisedFit& fitted) {
    const Eigen::VectorXd tensions = fitted.model().tensions(fitted.iterate);
    const Eigen::VectorXd& variances = fitted.covariance.tensions;
    std::vector<Eigen::Index> result;
    for (int i = 0; i < fit_net.interior_edge_count(); ++i) {
        const int edge = fit_net.interior_edges()[i];
        const bool is_close =
            !fit_net.is_strut(edge) && tensions(edge) < std::sqrt(std::max(0.0, variances(edge)));
        if (fitted.model().slack[edge] ||
            (is_close && !std::ranges::binary_search(net.adjustable_edges(), edge))) {
            result.push_back(i);
        }
    }
    return result;
}

/// Reports the released interior edges and boundary. Adjustable edges of uncertain length are
/// interior edges of the fit.
void set_outliers(Identification& result, const CableNet& net, const SurveyFit& fit) {
    result.boundary_outliers = boundary_outliers(fit.hypotheses);
    for (const LengthOutlier& outlier : fit.length_outliers) {
        if (std::ranges::binary_search(net.interior_edges(), outlier.edge)) {
            result.length_outliers.push_back(outlier);
            continue;
        }
        BoundaryOutlier turned{.kind = BoundaryOutlier::Kind::adjustable_edge,
                               .index = outlier.edge,
                               .statistic = outlier.statistic};
        turned.deviation.x() = outlier.deviation;
        turned.std_dev.x() = outlier.std_dev;
        result.boundary_outliers.push_back(turned);
    }
    std::ranges::stable_sort(result.boundary_outliers, std::greater{}, &BoundaryOutlier::statistic);
}

/// Leaves out the estimates of released adjustable edges: their deviation is reported instead.
void leave_out_released(Identification& result) {
    std::erase_if(result.uncertain, [&](const ParameterEstimate& one) {
        return one.parameter.kind == UncertainParameter::Kind::adjustable &&
               std::ranges::any_of(result.boundary_outliers, [&](const BoundaryOutlier& outlier) {
                   return outlier.kind == BoundaryOutlier::Kind::adjustable_edge &&
                          outlier.index == one.edge;
               });
    });
}

/// (marginal-mode), where so many edges make a difference.
void move_to_marginal_mode(SurveyFit& fit, const SurveyFitSettings& settings) {
    const StaticsModel model = fit.at.model();
    const int count = model.common.given_count();
    if (model.net().interior_edge_count() < fewest_for_marginal_mode || count == 0) {
        return;
    }
    Observations moved = with_marginal_mode(fit.at, fit.observations, count);
    GaussNewtonResult found = gauss_newton(model, moved, fit.at.iterate, fit.tolerance,
                                           settings.max_iterations, settings.progress);
    if (found.converged) {
        Covariance covariance = found.linearisation->covariance();
        fit.at = {std::move(found.iterate), *std::move(found.linearisation), std::move(covariance)};
        fit.observations = std::move(moved);
    }
}

constexpr int most_refits = 5;  ///< until friction is a part of the tensions found, (slips)

/// @param common_count of the evidence of the survey alone, with this number of common parameters;
///   empty: no evidence is wanted
IdentifiedEpoch identify_by_map(const CableNet& net, const Survey& survey, const Given& given,
                                const SurveyFitSettings& settings, const PosteriorSettings& wanted,
                                std::optional<int> common_count, const Progress& progress) {
    check_survey(net, survey);
    check_uncertain_parameters(net, given.uncertain);
    IdentifiedEpoch epoch;
    Identification& result = epoch.identification;
    const bool only_lengths = given.uncertain.empty() && given.forces.empty() && !given.evidence &&
                              net.sliding_nodes().empty();
    if (survey.is_exact() && survey.is_whole() && only_lengths) {
        result = identify_by_exact_balance(net, survey, given.prior);
        result.method = "map";
        return epoch;
    }
    const CableNet fit_net = net_to_fit(net, given.uncertain);
    PriorKnowledge all = knowledge_of(
        fit_net, given.prior, given.uncertain, given.forces,
        given.own_stds.size() > 0 ? given.own_stds : adjustable_stds(net, given.uncertain));
    all.evidence = given.evidence;
    all.frame_is_unknown = survey.frame_is_unknown;
    all.test_loads = given.test_loads;
    SurveyFitSettings fitting = settings;
    fitting.progress = progress;
    MarkedFit marked =
        fit_with_marks(fit_net, survey, all, fitting);  // (map), (slack-form), (snooping)
    for (int again = 0;
         again < most_refits && !all.stretches.empty() && marked.fit.converged &&
         all.take_up_tensions(marked.fit.at.model().common, marked.fit.at.iterate.common);
         ++again) {
        marked = fit_with_marks(fit_net, survey, all, fitting);
    }
    SurveyFit& fit = marked.fit;
    const PriorKnowledge& knowledge = fit.knowledge;
    LoadCheck loads;
    if (fit.converged) {
        loads = check_loads(fit.at, fit.hypotheses.residual_scale);
        move_to_marginal_mode(fit, fitting);
    }
    LinearisedFit fitted = std::move(fit.at);
    Observations observations = fit.observations;
    FitDiagnostics shown;
    if (fit.converged) {
        const StaticsModel model = fitted.model();
        const Iterate at = fitted.iterate;
        shown = diagnostics_of(net, fit_net, given, fit, std::move(fitted));
        shown.loads = loads;
        fitted = linearised_fit(model, at, observations);
    }
    if (common_count) {
        epoch.own = fit.converged ? forgotten(own_evidence(fitted, observations, *common_count),
                                              edges_maybe_slack(net, fit_net, fitted))
                                  : no_evidence(fit_net.interior_edge_count() + *common_count);
    }
    if (fit.converged) {
        Propagated propagated =
            propagate_prior(knowledge, std::move(fitted), observations, fit.tolerance);
        fitted = std::move(propagated.fit);
        observations = std::move(propagated.observations);
    }
    result =
        identification_of(net, fit_net, survey, given.prior, knowledge, fit, fitted, observations);
    result.force_measurements = static_cast<int>(given.forces.measurements.size());
    result.force_outliers = fit.force_outliers;
    result.force_bias = force_bias(fit.hypotheses);
    result.prior = shown.estimate.value_or(exact_prior(given.prior));
    const LengthTrend trend =
        given.has_trend && fit.converged
            ? trend_of(fitted, observations, shown.left_out, shown.adjustable_stds, given.prior)
            : LengthTrend();
    result.prior.common = trend.found;
    if (fit.converged) {
        result.detectable = detectable_of(net, fit_net, survey, fit, all.priors, shown);
    }
    result.scales = shown.scales;
    result.prior_check = shown.prior;
    result.frame_check = shown.frame;
    result.load_check = shown.loads;
    result.frame_check.scale_std = std::hypot(shown.frame.scale_std, survey.scale_std);
    set_outliers(result, net, fit);
    result.boundary_not_released = fit.hypotheses.suspicious_count(Hypotheses::Family::boundary);
    result.contradicted_taut = std::move(marked.contradicted_taut);
    result.contradicted_slack = std::move(marked.contradicted_slack);
    if (fitted.model().common.has_frame()) {
        result.frame_offset = frame_offset_of(fitted);
    }
    result.uncertain = parameter_estimates(net, knowledge, fitted, observations);
    leave_out_released(result);
    take_up_slips(result, net, knowledge, fitted, observations);
    if (!trend.empty()) {
        take_up_trend(result, trend, knowledge, fitted);
        observations.mean_root = trend.columns * trend.prior_stds.asDiagonal();
        observations.shown_mean = trend.mean.cwiseQuotient(trend.prior_stds);
        observations.shown_root = trend.prior_stds.cwiseInverse().asDiagonal() * trend.root;
    }
    if (!fit_net.is_linear()) {
        StaticsModel fixed = fitted.model();
        fixed.fix_tension_laws(fitted.iterate);  // (drawn-law)
        fitted.linearisation = std::move(fitted.linearisation).under(std::move(fixed));
    }
    if (fit.converged) {
        result.form_covariance = fitted.covariance.places;
    }
    draw_posterior(result, net, fit_net, survey, knowledge, fitted, observations, wanted, progress);
    if (!wanted.covariance_of.empty() && fit.converged) {
        // After the draws, which may widen the standard deviations.
        result.length_covariance =
            covariance_of(wanted.covariance_of, fitted, observations, trend, result);
    }
    predict_form(result, net, survey, fitted.iterate.form, given.test_loads);
    set_stretch_means(result, net);
    result.method = "map";
    return epoch;
}

}  // namespace

Identification identify_by_maximum_a_posteriori(const CableNet& net, const Survey& survey,
                                                const Given& given,
                                                const SurveyFitSettings& settings,
                                                const PosteriorSettings& wanted,
                                                const Progress& progress) {
    return identify_by_map(net, survey, given, settings, wanted, std::nullopt, progress)
        .identification;
}

IdentifiedEpoch identify_one_epoch(const CableNet& net, const Survey& survey, const Given& given,
                                   int common_count, const Progress& progress) {
    return identify_by_map(net, survey, given, {}, {}, common_count, progress);
}

Identification identification_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                                 const LengthPrior& prior, const PriorKnowledge& knowledge,
                                 const SurveyFit& fit, const LinearisedFit& fitted,
                                 const Observations& observations) {
    Identification result;
    if (!fit.converged) {
        result.status = IdentificationStatus::iteration_limit;
        result.message = why_not_converged(net, survey, prior);
    }
    set_snooping(result, survey, fit.hypotheses, fit.outliers, fit.contradicts_too_many);
    std::vector<LengthLikelihood> likelihoods =
        length_likelihoods(knowledge, fitted.model(), fitted.covariance, observations,
                           fitted.iterate);  // (covariance), (likelihood), (posterior)
    if (fit_net.interior_edge_count() > net.interior_edge_count()) {
        std::vector<LengthLikelihood> interior;
        for (const int edge : net.interior_edges()) {
            interior.push_back(likelihoods[edge]);
        }
        likelihoods = std::move(interior);
    }
    result.length_prior = prior;
    set_edges(result, net, interior_priors(net, knowledge), likelihoods);
    for (IdentifiedEdge& edge : result.edges) {
        // Marked slack, though the form leaves hardly any length of the prior for that.
        if (std::ranges::find(knowledge.forces.slack, edge.edge) != knowledge.forces.slack.end()) {
            edge.status = EdgeStatus::slack;
        }
    }
    return result;
}

}  // namespace taut
