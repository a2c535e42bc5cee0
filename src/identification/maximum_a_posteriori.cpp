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
#include "estimation/detectable_error.hpp"
#include "estimation/expectation_propagation.hpp"
#include "estimation/frame_check.hpp"
#include "estimation/gauss_newton.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/length_tests.hpp"
#include "estimation/length_trend.hpp"
#include "estimation/load_check.hpp"
#include "estimation/marginal_mode.hpp"
#include "estimation/prior_check.hpp"
#include "estimation/target_tests.hpp"
#include "estimation/variance_components.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/parameter_estimates.hpp"
#include "taut/estimation/edge_status.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The likely reason, and what would help.
std::string why_not_converged(const CableNet& net, const Survey& survey, const LengthPrior& prior) {
    const double stretch = mean_stretch(net);
    std::string text = "The fit did not converge within its iteration limit. ";
    if (stretch < prior.std()) {
        text += fmt::format(
            "The mean stretch of the cables is {:.2g} mm and the prior of their lengths +-{:.2g} "
            "mm, so any of them may be slack. A narrower prior would help, if it is true.",
            1e3 * stretch, 1e3 * prior.std());
    } else {
        text += "Check net, loads, frame and noise.";
    }
    if (!survey.is_whole()) {
        text += fmt::format(" A survey of the {} missing nodes would help.", survey.missing.size());
    }
    return text;
}

/// Whether the survey does not contradict the marks of slack and taut edges: whether the fit with
/// them costs no more, beyond chance, than the fit without.
bool is_believable(const SurveyFit& with, const SurveyFit& without, const Forces& seen) {
    constexpr double by_chance = 20.0;    // a normal error of 4.5 standard deviations
    constexpr double a_slack_edge = 9.0;  // may be this far from the mean of its prior
    // An edge kept taut may carry pressure in the fit, which costs nothing.
    constexpr double surely = 4.0;  // standard deviations
    const Eigen::VectorXd tensions = with.at.model().tensions(with.at.iterate);
    const Eigen::VectorXd& variances = with.at.covariance.tensions;
    const bool has_pressure = std::ranges::any_of(seen.taut, [&](int edge) {
        return tensions(edge) < -surely * std::sqrt(std::max(0.0, variances(edge)));
    });
    return !has_pressure && with.cost <= without.cost + by_chance +
                                             a_slack_edge * static_cast<double>(seen.slack.size());
}

/// Reports the marked edges that the fit without marks contradicts; where there are none, all.
void set_contradicted_marks(Identification& result, const LinearisedFit& without,
                            const Forces& seen) {
    constexpr double surely = 3.0;  // standard deviations
    const Eigen::VectorXd tensions = without.model().tensions(without.iterate);
    const Eigen::VectorXd stds = without.covariance.tensions.cwiseMax(0.0).cwiseSqrt();
    std::ranges::copy_if(seen.taut, std::back_inserter(result.contradicted_taut), [&](int edge) {
        return without.model().slack[edge] || tensions(edge) < -surely * stds(edge);
    });
    std::ranges::copy_if(seen.slack, std::back_inserter(result.contradicted_slack),
                         [&](int edge) { return tensions(edge) > surely * stds(edge); });
    if (result.contradicted_taut.empty() && result.contradicted_slack.empty()) {
        result.contradicted_taut = seen.taut;
        result.contradicted_slack = seen.slack;
    }
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

/// What a fit shows of noise, prior and frame.
struct Diagnostics {
    VarianceComponents scales;
    PriorCheck prior;
    FrameCheck frame;
    LoadCheck loads;
    std::optional<PriorEstimate> estimate;
    std::vector<bool> left_out;       ///< interior edges (m_I) that do not follow the prior
    Eigen::VectorXd adjustable_stds;  ///< prior std of adjustable edges as built, else 0 (m_I)
};

/// (common-mean): score and information of a shift of the prior. None where (marginal-mode) moves
/// it farther than a linearisation holds.
void set_mean(PriorCheck& check, const LinearisedFit& fitted, const Observations& observations,
              const std::vector<bool>& left_out) {
    Eigen::VectorXd weights = observations.variance.cwiseInverse();
    for (size_t i = 0; i < left_out.size(); ++i) {
        if (left_out[i]) {
            weights(static_cast<Eigen::Index>(i)) = 0.0;
        }
    }
    const double information =
        weights.sum() -
        weights.dot(fitted.linearisation.response_to_lengths(weights).lengths.col(0));
    constexpr double rounding = 1e-6;
    if (!(information > rounding * weights.sum())) {
        return;
    }
    double by_mode = 0.0;
    double by_mode_std = 0.0;
    if (weights.size() >= fewest_for_marginal_mode) {
        constexpr double known_to = 0.5;  // the slope changes on the way: by trial
        constexpr double farthest = 4.0;  // standard deviations of the prior
        const double h = 0.1 * check.checked.std();
        Observations moved = observations;
        moved.mean.array() += h * (weights.array() > 0.0).cast<double>();
        by_mode = DeterminantSlope(fitted, observations).change(moved) / h / information;
        if (!(std::abs(by_mode) < farthest * check.checked.std())) {
            return;
        }
        by_mode_std = known_to * std::abs(by_mode);
    }
    const double score = weights.dot(fitted.iterate.deviations - observations.mean);
    check.mean = score / information - by_mode;
    check.mean_std = std::hypot(1.0 / std::sqrt(information), by_mode_std);
}

/// (components), (prior-check)
Diagnostics diagnostics_of(const CableNet& net, const CableNet& fit_net, const Given& given,
                           const SurveyFit& fit, LinearisedFit fitted) {
    const LengthPrior& prior = given.prior;
    Diagnostics shown;
    const Iterate at = fitted.iterate;
    const std::vector<bool> slack = fitted.model().slack;
    const Observations observed = fit.observations;
    Observations scaled = observed;
    shown.frame = check_frame(fitted, observed, fit.hypotheses.residual_scale);
    std::vector<bool> left_out = fit.hypotheses.released_lengths();
    shown.adjustable_stds = Eigen::VectorXd::Zero(fit_net.interior_edge_count());
    for (int i = 0; i < fit_net.interior_edge_count(); ++i) {
        const int edge = fit_net.interior_edges()[i];
        const bool is_adjustable = std::ranges::binary_search(net.adjustable_edges(), edge);
        if (is_adjustable && !left_out[i] && !slack[edge]) {
            shown.adjustable_stds(i) = given.unturned_std.value_or(
                std_of(given.uncertain, UncertainParameter::Kind::adjustable));
        }
        left_out[i] = left_out[i] || slack[edge] || fit.knowledge.priors[i] != prior;
    }
    shown.scales = estimate_components(fitted, scaled, left_out);
    const PriorLikelihood likelihood(prior,
                                     length_likelihoods(fit.knowledge, fitted.model(),
                                                        fitted.covariance, scaled, fitted.iterate),
                                     left_out);
    shown.prior = check_prior_by_lengths(prior, likelihood);
    shown.prior.outliers = fit.hypotheses.given_up();
    set_mean(shown.prior, fitted, scaled, left_out);
    if (given.hyperprior) {
        fitted.iterate = at;
        shown.estimate = estimate_prior(*given.hyperprior, std::move(fitted), observed, left_out,
                                        prior, shown.scales.lengths, likelihood);
    }
    shown.left_out = std::move(left_out);
    return shown;
}

/// (detectable)
/// @param priors as given to the fit (m_I)
DetectableErrors detectable_of(const CableNet& net, const CableNet& fit_net, const Survey& survey,
                               const SurveyFit& fit, const std::vector<LengthPrior>& priors,
                               const Diagnostics& shown) {
    const Hypotheses& tested = fit.hypotheses;
    const auto length = [&](const std::vector<int>& edges) {
        return detectable_length(tested, fit_net, priors, edges);
    };
    DetectableErrors result{.target = tested.detectable(Suspect::target),
                            .length = length(net.interior_edges()),
                            .adjustable = std::min(length(net.adjustable_edges()),
                                                   tested.detectable(Suspect::adjustable_edge)),
                            .support = tested.detectable(Suspect::support)};
    const Points arms = net.nodes().colwise() - net.nodes().rowwise().mean();
    const double reach = arms.colwise().norm().maxCoeff();
    const double scale_std =
        shown.frame.scale_std > 0.0 ? std::hypot(shown.frame.scale_std, survey.scale_std) : 0.0;
    result.scale = detectable_error(std::vector<BoundedEstimate>{
        {.bound = std::max(significant_std * scale_std,
                           negligible_scale * survey.rms_noise_std() / reach),
         .std = scale_std}});
    const double mean = detectable_error(std::vector<BoundedEstimate>{
        {.bound = std::max(significant_std * shown.prior.mean_std,
                           negligible_mean * shown.prior.checked.std()),
         .std = shown.prior.mean_std}});
    const double load = detectable_error(std::vector<BoundedEstimate>{
        {.bound = significant_std * shown.loads.std, .std = shown.loads.std}});
    // No net carries more.
    if (load <= imbalance(net, net.unstressed_lengths(), net.nodes()).mean_tension) {
        result.load = load;
    }
    constexpr double of_steel = 12e-6;  // [1/K]
    double expansion = 0.0;             // mean, by 1 K [m]
    const Eigen::VectorXd& of_net = net.data().expansion;
    for (const int edge : net.interior_edges()) {
        const double of_edge = of_net.size() > 0 ? of_net(edge) : of_steel;
        expansion += of_edge * net.unstressed_lengths()(edge) / net.interior_edge_count();
    }
    constexpr double largest_difference = 100.0;  // no site has more [K]
    if (const double temperature = mean / std::abs(expansion); temperature <= largest_difference) {
        result.temperature = temperature;
    }
    for (const Hypothesis& forces : tested.of(Suspect::force_scale)) {
        const double std = forces.std()(0);
        result.force_scale = detectable_error(
            std::vector<BoundedEstimate>{{.bound = std::sqrt(forces.threshold) * std, .std = std}});
    }
    return result;
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

/// The rows of the gains for these edges.
Eigen::MatrixXd gains_of(const std::vector<int>& edges, const CableNet& fit_net,
                         const LengthTrend& trend) {
    std::vector<Eigen::Index> rows(edges.size());
    std::ranges::transform(edges, rows.begin(), [&](int edge) {
        return std::ranges::lower_bound(fit_net.interior_edges(), edge) -
               fit_net.interior_edges().begin();
    });
    return trend.length_gains(rows, Eigen::all);
}

/// (length-trend): adds what the lengths have in common to the result of a fit without it.
void take_up_trend(Identification& result, const LengthTrend& trend, const CableNet& fit_net) {
    std::vector<int> edges;
    std::ranges::transform(result.edges, std::back_inserter(edges), &IdentifiedEdge::edge);
    const Eigen::MatrixXd gains = gains_of(edges, fit_net, trend);
    const Eigen::VectorXd shifts = gains * trend.mean;
    const Eigen::VectorXd stds = (gains * trend.root).rowwise().norm();
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (edge.status == EdgeStatus::slack || !(edge.std > 0.0)) {
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        const double std = std::hypot(edge.std, stds(k));
        const double wider = std / edge.std;
        const double before = edge.length_deviation;
        edge.length_deviation += shifts(k);
        edge.lower = edge.length_deviation - wider * (before - edge.lower);
        edge.upper = edge.length_deviation + wider * (edge.upper - before);
        edge.std = std;
        edge.status = status_of(result.length_prior.std(), {.std = std, .slack_probability = 0.0});
    }
    Eigen::Index common = 0;
    for (ParameterEstimate& one : result.uncertain) {
        Eigen::RowVectorXd gain = Eigen::RowVectorXd::Zero(trend.mean.size());
        if (one.edge < 0 && one.node < 0) {
            gain = one.parameter.std * trend.common_gains.row(common++);
        } else if (one.parameter.kind == UncertainParameter::Kind::adjustable) {
            gain = gains_of({one.edge}, fit_net, trend);
            one.prior_std = std::hypot(one.prior_std, trend.adjustable_std);
        }
        one.mean += gain * trend.mean;
        one.std = std::hypot(one.std, (gain * trend.root).norm());
    }
}

LengthCovariance covariance_of(const std::vector<int>& edges, const CableNet& fit_net,
                               const Linearisation& linearisation, const LengthTrend& trend,
                               const Identification& result) {
    Eigen::MatrixXd linearised = linearisation.length_covariance(edges);
    if (!trend.empty()) {
        const Eigen::MatrixXd common = gains_of(edges, fit_net, trend) * trend.root;
        linearised += common * common.transpose();
    }
    Eigen::VectorXd scale(edges.size());
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
        const auto edge = std::ranges::find(result.edges, edges[k], &IdentifiedEdge::edge);
        const double std = std::sqrt(linearised(k, k));
        scale(k) = std > 0.0 ? edge->std / std : 0.0;
    }
    return {.edges = edges, .covariance = linearised.cwiseProduct(scale * scale.transpose())};
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
        turned.std.x() = outlier.std;
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
    const int count = model.common.kept_count() - (model.common.has_frame() ? 6 : 0);
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

/// @param common_count of the evidence of the survey alone, with this number of common parameters;
///   empty: no evidence is wanted
IdentifiedEpoch identify_by_map(const CableNet& net, const Survey& survey, const Given& given,
                                const SurveyFitSettings& settings, const PosteriorSettings& wanted,
                                std::optional<int> common_count, const Progress& progress) {
    check_survey(net, survey);
    check_uncertain_parameters(net, given.uncertain);
    IdentifiedEpoch epoch;
    Identification& result = epoch.identification;
    const bool only_lengths = given.uncertain.empty() && given.forces.empty() && !given.evidence;
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
    PriorKnowledge unseen = all;
    unseen.forces.taut.clear();
    unseen.forces.slack.clear();
    SurveyFitSettings fitting = settings;
    fitting.progress = {.report = {}, .stop_requested = progress.stop_requested};
    SurveyFit fit = fit_survey(fit_net, survey, all, fitting);  // (map), (slack-form), (snooping)
    Identification verdict;
    if (!given.forces.taut.empty() || !given.forces.slack.empty()) {
        SurveyFit without = fit_survey(fit_net, survey, unseen, fitting);
        if (!is_believable(fit, without, given.forces)) {
            set_contradicted_marks(verdict, without.at, given.forces);
            fit = std::move(without);
        }
    }
    const PriorKnowledge& knowledge = fit.knowledge;
    LoadCheck loads;
    if (fit.converged) {
        loads = check_loads(fit.at, fit.hypotheses.residual_scale);
        move_to_marginal_mode(fit, fitting);
    }
    LinearisedFit fitted = std::move(fit.at);
    Observations observations = fit.observations;
    Diagnostics shown;
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
    result.contradicted_taut = std::move(verdict.contradicted_taut);
    result.contradicted_slack = std::move(verdict.contradicted_slack);
    if (fitted.model().common.has_frame()) {
        result.frame_offset = frame_offset_of(fitted);
    }
    result.uncertain = parameter_estimates(net, knowledge, fitted, observations);
    leave_out_released(result);
    if (!trend.empty()) {
        take_up_trend(result, trend, fit_net);
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
            covariance_of(wanted.covariance_of, fit_net, fitted.linearisation, trend, result);
    }
    predict_form(result, net, survey, fitted.iterate.form);
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
