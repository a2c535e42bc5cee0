// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/identify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "estimation/hyperprior.hpp"
#include "estimation/perturbed_draws.hpp"
#include "identification/assumptions.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/mean_bias.hpp"
#include "identification/net_balance.hpp"
#include "identification/prior_mixture.hpp"
#include "identification/processes.hpp"
#include "numerics/parallel.hpp"
#include "platform/platform.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

constexpr std::array methods{IdentificationMethod::balance, IdentificationMethod::map,
                             IdentificationMethod::gp};

struct Choice {
    IdentificationMethod method = IdentificationMethod::balance;
    std::string reason;
};

/// The method asked for, or the one that suits the input.
Choice choose_method(const Survey& survey, const IdentifyOptions& options) {
    if (options.method) {
        return {.method = *options.method, .reason = "this method was asked for"};
    }
    if (options.model != nullptr) {
        return {.method = IdentificationMethod::gp, .reason = "a model is given"};
    }
    if (!survey.is_whole()) {
        return {.method = IdentificationMethod::map,
                .reason = fmt::format("{} free nodes were not surveyed", survey.missing.size())};
    }
    if (survey.is_noisy()) {
        return {.method = IdentificationMethod::map, .reason = "the survey has noise"};
    }
    if (!options.forces.empty()) {
        return {.method = IdentificationMethod::map, .reason = "forces are given"};
    }
    if (!options.uncertain.empty()) {
        return {.method = IdentificationMethod::map, .reason = "more than lengths is uncertain"};
    }
    return {.method = IdentificationMethod::balance,
            .reason = "all free nodes were surveyed, and the survey is exact"};
}

/// Requirements of a method on the survey.
void check_survey_for(const CableNet& net, const Survey& survey, IdentificationMethod method) {
    if (method == IdentificationMethod::balance) {
        require_whole(net, survey, "all for the method balance");
    }
    if (survey.is_exact()) {
        require_whole(net, survey, "all, or their noise (standard deviations)");
    }
}

/// Refuses input that the method does not use.
void check_for_method(const IdentifyOptions& options, IdentificationMethod method) {
    if (options.model != nullptr && method != IdentificationMethod::gp) {
        throw std::invalid_argument(
            fmt::format("a model is for the method gp, not for {}", to_string(method)));
    }
    if (method == IdentificationMethod::map) {
        return;
    }
    if (!options.covariance_of.empty()) {
        throw std::invalid_argument(fmt::format(
            "covariances of lengths are for the method map, not for {}", to_string(method)));
    }
    if (!options.forces.empty()) {
        throw std::invalid_argument(fmt::format(
            "forces and marks of taut and slack edges are for the method map, not for {}",
            to_string(method)));
    }
    if (options.uncertain.empty()) {
        return;
    }
    if (method != IdentificationMethod::gp) {
        throw std::invalid_argument(fmt::format(
            "uncertain parameters are for the methods map and gp, not for {}", to_string(method)));
    }
    if (options.model != nullptr && options.model->uncertain != options.uncertain) {
        throw std::invalid_argument(
            fmt::format("the model was trained with the uncertain parameters {}, expected {}. Draw "
                        "its samples with these",
                        to_string(options.model->uncertain), to_string(options.uncertain)));
    }
}

void check_covariance_of(const CableNet& net, const std::vector<int>& edges) {
    std::set<int> seen;
    for (const int edge : edges) {
        if (!std::ranges::binary_search(net.interior_edges(), edge)) {
            throw std::invalid_argument(fmt::format(
                "covariances of lengths: edge {} is no interior edge of the net", edge));
        }
        if (!seen.insert(edge).second) {
            throw std::invalid_argument(
                fmt::format("covariances of lengths: edge {} is named twice", edge));
        }
    }
}

/// A model for the net and the prior, on samples drawn now.
LengthModel trained_model(const CableNet& net, const LengthPrior& prior,
                          const std::vector<UncertainParameter>& uncertain, int samples,
                          const Progress& progress) {
    const Sampler sampler(net, prior, /*seed=*/1, uncertain);
    const DataSet data = draw_samples(sampler, samples, progress);
    return train(net, data, data.converged_in(0, data.size()), {}, progress);
}

std::string how_text(const LengthModel& model, bool is_given, const Survey& survey) {
    std::string text = fmt::format("Gaussian processes trained on {} samples of {}{}",
                                   model.training_count(), model.prior.to_string(),
                                   is_given ? "" : " (no model was given, so they were drawn now)");
    if (!model.uncertain.empty()) {
        text += ", drawn with " + to_string(model.uncertain);
    }
    if (model.as_in_paper && survey.is_noisy()) {
        text +=
            "\n  as in the paper, which treats the survey as exact: its noise is not in the "
            "intervals";
    }
    return text;
}

Identification identify_by_model(const CableNet& net, const Survey& survey,
                                 const LengthModel& model) {
    if (survey.is_exact() && model.uncertain.empty()) {
        // The processes cannot show whether a form is that of any lengths: the balance can.
        Identification balance = check_exactness(net, survey, model.prior);
        if (balance.status != IdentificationStatus::converged) {
            return balance;
        }
    }
    return model.as_in_paper ? identify_as_in_paper(net, model, survey)
                             : identify_by_processes(net, model, survey);
}

/// A prior for a fit, and the distribution over priors around it.
struct AssumedPrior {
    LengthPrior prior;
    std::optional<Hyperprior> around;  ///< empty: the prior is exact
    bool has_trend = false;            ///< Given::has_trend
    PosteriorSettings wanted;
};

PosteriorSettings wanted_by(const IdentifyOptions& options) {
    return {.count = options.draws, .seed = options.seed, .covariance_of = options.covariance_of};
}

/// A fit of its own, which shows noise, prior, length outliers and frame for any method.
/// @return empty where the survey is exact, or the fit does not converge
std::optional<Identification> audit(const CableNet& net, const Survey& survey,
                                    const AssumedPrior& prior,
                                    const std::vector<UncertainParameter>& uncertain,
                                    const Progress& progress) {
    if (!survey.is_noisy()) {
        return std::nullopt;
    }
    Given given(prior.prior, uncertain);
    given.hyperprior = prior.around;
    Identification fit = identify_by_maximum_a_posteriori(net, survey, given, {}, {}, progress);
    if (fit.status != IdentificationStatus::converged) {
        return std::nullopt;
    }
    return fit;
}

Survey brought_into_frame(const Survey& survey, const FrameOffset& offset) {
    Survey result = survey;
    const Points motion = offset.motion_of(survey.form);
    result.form(Eigen::all, survey.surveyed) -= motion(Eigen::all, survey.surveyed);
    return result;
}

void take_over(Identification& result, const Identification& fit, const CableNet& net,
               const Survey& survey) {
    result.prior = fit.prior;
    result.detectable = fit.detectable;
    result.scales = fit.scales;
    result.prior_check = fit.prior_check;
    result.frame_check = fit.frame_check;
    result.load_check = fit.load_check;
    result.length_outliers = fit.length_outliers;
    result.boundary_outliers = fit.boundary_outliers;
    result.boundary_not_released = fit.boundary_not_released;
    for (const LengthOutlier& outlier : fit.length_outliers) {
        const auto is_same = [&](const IdentifiedEdge& edge) { return edge.edge == outlier.edge; };
        const auto edge = std::ranges::find_if(result.edges, is_same);
        if (edge != result.edges.end()) {
            *edge = *std::ranges::find_if(fit.edges, is_same);
        }
    }
    result.frame_offset = fit.frame_offset;
    const bool is_changed =
        !fit.length_outliers.empty() || fit.frame_offset || !fit.boundary_outliers.empty();
    if (is_changed && result.status == IdentificationStatus::converged) {
        predict_form(result, net, survey, fit.predicted.form);
    }
}

/// The factor on the noise that fits the survey, without gross errors, (components).
double noise_scale_of(const CableNet& net, const Survey& survey, const LengthPrior& prior,
                      const IdentifyOptions& options, const Progress& progress) {
    if (!survey.is_noisy()) {
        throw std::invalid_argument("estimate_noise is for a survey that is not exact");
    }
    constexpr int most_rounds = 8;
    constexpr double converged = 0.01;
    constexpr double least_known = 0.25;  // largest relative std of a usable estimate
    const Given given(prior, options.uncertain, options.forces);
    Survey scaled = survey;
    double scale = 1.0;
    for (int round = 0; round < most_rounds; ++round) {
        const Identification fit =
            identify_by_maximum_a_posteriori(net, scaled, given, {}, {}, progress);
        if (fit.status != IdentificationStatus::converged) {
            return scale;  // the result reports it
        }
        const double ratio = fit.scales.noise.ratio;
        if (!(fit.scales.noise.std < least_known * ratio)) {
            break;
        }
        scaled = with_noise_times(std::move(scaled), ratio);
        scale *= ratio;
        if (std::abs(ratio - 1.0) < converged) {
            return scale;
        }
    }
    throw SurveyError(0,
                      "does not show its noise: it has too little redundancy. Give its standard "
                      "deviation");
}

Identification identify_by(IdentificationMethod method, const CableNet& net, const Survey& survey,
                           const AssumedPrior& prior, const LengthModel* model,
                           const IdentifyOptions& options, const Progress& progress) {
    Identification result;
    switch (method) {
        case IdentificationMethod::balance:
            result = identify_by_force_balance(net, survey, prior.prior);
            result.how = fmt::format("force balance at the surveyed form, lengths {}",
                                     prior.prior.to_string());
            break;
        case IdentificationMethod::map: {
            Given given(prior.prior, options.uncertain, options.forces);
            given.hyperprior = prior.around;
            given.has_trend = prior.has_trend;
            result =
                identify_by_maximum_a_posteriori(net, survey, given, {}, prior.wanted, progress);
            result.how = fmt::format("maximum a posteriori under the statics, lengths {}",
                                     prior.prior.to_string());
            break;
        }
        case IdentificationMethod::gp:
            result = identify_by_model(net, survey, *model);
            result.how = how_text(*model, options.model != nullptr, survey);
            break;
    }
    return result;
}

/// By a method, with the audit of the survey.
Identification identify_and_audit(IdentificationMethod method, const CableNet& net,
                                  const Survey& survey, const AssumedPrior& prior,
                                  const IdentifyOptions& options, const Progress& progress) {
    std::optional<LengthModel> own;
    if (method == IdentificationMethod::gp && options.model == nullptr) {
        own =
            trained_model(net, prior.prior, options.uncertain, options.training_samples, progress);
    }
    const auto by_method = [&](const Survey& in_frame) {
        return identify_by(method, net, in_frame, prior, own ? &*own : options.model, options,
                           progress);
    };
    if (method == IdentificationMethod::map) {
        return by_method(survey);
    }
    // In parallel, since few surveys turn out to be off their frame.
    std::optional<Identification> fit;
    Identification result;
    parallel_invoke([&] { fit = audit(net, survey, prior, options.uncertain, progress); },
                    [&] { result = by_method(survey); });
    result.prior = exact_prior(prior.prior);
    if (fit) {
        if (fit->frame_offset) {
            result = by_method(brought_into_frame(survey, *fit->frame_offset));
        }
        take_over(result, *fit, net, survey);
    }
    return result;
}

/// Distance of two standard deviations, as a logarithm.
double distance(double std, const LengthPrior& prior) {
    return std::abs(std::log(std / prior.std()));
}

/// A fit with a prior far from the truth rejects sound targets and lengths. So it is repeated with
/// the prior that it shows, until that stays.
/// @return with the last prior
std::pair<Identification, AssumedPrior> identify_at_centre(
    IdentificationMethod method, const CableNet& net, const Survey& survey,
    const AssumedPrior& first, const IdentifyOptions& options, const Progress& progress) {
    constexpr double far = 0.25;
    constexpr int most_centres = 3;
    AssumedPrior prior = first;
    Identification result = identify_and_audit(method, net, survey, prior, options, progress);
    const PriorCheck by_given = result.prior_check;
    for (int k = 0; k < most_centres && result.status == IdentificationStatus::converged &&
                    !result.prior.exact && distance(result.prior.std, prior.prior) > far;
         ++k) {
        prior.prior = central_prior(result.prior);
        result = identify_and_audit(method, net, survey, prior, options, progress);
    }
    if (options.prior && by_given.is_untenable() && !by_given.is_too_wide()) {
        result.contradicted_prior = by_given;
    }
    return {std::move(result), prior};
}

/// (prior-mixture): by each prior of the posterior, mixed.
Identification identify_over_priors(IdentificationMethod method, const CableNet& net,
                                    const Survey& survey, const IdentifyOptions& options,
                                    const Progress& progress) {
    constexpr double as_good_as = 0.05;
    const Hyperprior around =
        options.prior ? hyperprior_around(*options.prior) : broad_hyperprior();
    const PosteriorSettings wanted = wanted_by(options);
    AssumedPrior first{
        .prior = around.centre, .around = around, .has_trend = true, .wanted = wanted};
    if (can_be_chained(net)) {  // a mixture as a rule; else a fit more, which is short
        first.wanted.count = 0;
    }
    auto found = identify_at_centre(method, net, survey, first, options, progress);
    Identification& centre = found.first;
    const auto centre_alone = [&] {
        AssumedPrior by = found.second;
        if (method != IdentificationMethod::map || by.wanted.count == wanted.count) {
            return centre;
        }
        by.wanted = wanted;
        Identification drawn = identify_and_audit(method, net, survey, by, options, progress);
        drawn.contradicted_prior = centre.contradicted_prior;
        drawn.prior = centre.prior;
        return drawn;
    };
    PriorEstimate& prior = centre.prior;
    if (centre.status != IdentificationStatus::converged) {
        return centre;
    }
    if (prior.exact) {
        return centre_alone();
    }
    if (method == IdentificationMethod::gp && prior.nodes.size() > 1) {
        // Training takes long: one model for all.
        prior.nodes = {{.prior = central_prior(prior)}};
    }
    if (prior.nodes.size() == 1 && prior.nodes.front().prior.kind == centre.length_prior.kind &&
        distance(prior.nodes.front().prior.std(), centre.length_prior) < as_good_as) {
        prior.nodes.front().prior = centre.length_prior;
        return centre_alone();
    }
    auto mixture = mixture_over(
        net, survey, prior.nodes, wanted, [&](size_t k, const PosteriorSettings& of_part) {
            return std::optional(identify_and_audit(
                method, net, survey,
                {.prior = prior.nodes[k].prior, .around = {}, .has_trend = true, .wanted = of_part},
                options, progress));
        });
    if (!mixture) {
        return centre_alone();
    }
    Identification result = *std::move(mixture);
    prior.common = result.prior.common;
    result.prior = std::move(prior);
    result.contradicted_prior = centre.contradicted_prior;
    result.how +=
        fmt::format("\n  over {} priors: standard deviation of a length {:.2f} +- {:.2f} mm",
                    result.prior.nodes.size(), 1e3 * result.prior.std, 1e3 * result.prior.std_std);
    return result;
}

}  // namespace

std::string_view to_string(IdentificationMethod method) {
    switch (method) {
        case IdentificationMethod::balance:
            return "balance";
        case IdentificationMethod::map:
            return "map";
        case IdentificationMethod::gp:
            return "gp";
    }
    return "unknown";
}

IdentificationMethod parse_identification_method(std::string_view name) {
    for (const IdentificationMethod method : methods) {
        if (name == to_string(method)) {
            return method;
        }
    }
    throw std::invalid_argument(
        fmt::format("no method is called '{}', expected gp, balance or map", name));
}

int default_draws(const CableNet& net) {
    constexpr int few_edges = 10'000;
    // With tension laws each takes long.
    return net.interior_edge_count() > few_edges || !net.is_linear() ? 40 : 200;
}

void check_draws(const CableNet& net, std::int64_t draws) {
    // A draw is in memory twice while it is written.
    const double bytes_a_draw =
        2.0 * sizeof(double) *
        (net.interior_edge_count() + 3.0 * net.free_node_count() + net.edge_count());
    const double most = std::min(platform::physical_memory() / bytes_a_draw, 2147483647.0);
    if (draws < 0 || static_cast<double>(draws) > most) {
        throw std::invalid_argument(fmt::format(
            "draws is {}, expected 0 to {:.0f}, as many as fit into memory for this net", draws,
            most));
    }
}

void check_model(const CableNet& net, const LengthModel& model,
                 const std::optional<LengthPrior>& prior) {
    if (model.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the net {}, expected {} ('{}')",
                        model.net_fingerprint, net.fingerprint(), net.name()));
    }
    const Eigen::Index coordinates = Eigen::Index{3} * net.free_node_count();
    const gp::FittedProcesses& learnt = model.processes;
    if (model.nominal_form.size() != coordinates || model.input_scales.size() != coordinates ||
        learnt.inputs.rows() != coordinates ||
        std::ssize(learnt.processes) != net.interior_edge_count() ||
        learnt.weights.rows() != learnt.inputs.cols() ||
        learnt.weights.cols() != net.interior_edge_count() ||
        (model.form_prior.mean.size() > 0 &&
         model.form_prior.inputs.cols() != learnt.inputs.cols()) ||
        model.length_deviations.rows() != net.interior_edge_count() ||
        model.length_deviations.cols() != learnt.inputs.cols()) {
        throw std::invalid_argument(
            fmt::format("the model's parts are of {} coordinates, {} processes and {} samples, "
                        "expected {} and {} in each",
                        learnt.inputs.rows(), learnt.processes.size(), learnt.inputs.cols(),
                        coordinates, net.interior_edge_count()));
    }
    if (prior && model.prior != *prior) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the prior {}, expected {}",
                        model.prior.to_string(), prior->to_string()));
    }
}

KnownForces measured_by(const Forces& forces) {
    const auto by_cell = [](const ForceMeasurement& one) { return !one.is_by_mass(); };
    return {.by_cells = std::ranges::any_of(forces.measurements, by_cell)};
}

Identification identify(const CableNet& net, const Survey& survey, const IdentifyOptions& options,
                        const Progress& progress) {
    const LengthPrior prior =
        options.prior.value_or(options.model != nullptr ? options.model->prior : LengthPrior());
    check_prior(net, prior);
    check_draws(net, options.draws);
    check_survey(net, survey);
    const auto [method, reason] = choose_method(survey, options);
    check_survey_for(net, survey, method);
    check_forces(net, options.forces);
    check_for_one_survey(net, options.uncertain);
    check_covariance_of(net, options.covariance_of);
    check_for_method(options, method);
    if (options.model != nullptr) {
        check_model(net, *options.model, options.prior);
    }
    if (options.estimate_noise) {
        const double noise_scale = noise_scale_of(net, survey, prior, options, progress);
        const Survey scaled = with_noise_times(survey, noise_scale);
        IdentifyOptions with_noise = options;
        with_noise.estimate_noise = false;
        Identification result = identify(net, scaled, with_noise, progress);
        result.noise_scale = noise_scale;
        return result;
    }
    if (options.assume_site) {
        IdentifyOptions on_site = options;
        on_site.assume_site = false;
        std::vector<UncertainParameter> uncertain = options.uncertain;
        if (method == IdentificationMethod::map && survey.is_noisy()) {
            uncertain = with_site_assumptions(net, options.uncertain, measured_by(options.forces));
            on_site.uncertain = with_uncertain_widths(uncertain, options.uncertain);
        }
        Identification result = identify(net, survey, on_site, progress);
        result.method_reason = reason;
        name_assumed_widths(result, uncertain, options.uncertain);
        result.assumptions = assumptions_of(uncertain, options.uncertain, result);
        result.trust = trust_of(net, survey, result);
        return result;
    }
    const bool is_exact = options.prior_exact || options.model != nullptr || !survey.is_noisy();
    Identification result =
        is_exact ? identify_and_audit(method, net, survey,
                                      {.prior = prior, .around = {}, .wanted = wanted_by(options)},
                                      options, progress)
                 : identify_over_priors(method, net, survey, options, progress);
    if (is_exact) {
        result.prior = exact_prior(prior);
    }
    if (survey.is_noisy()) {
        take_out_mean_bias(result, net, survey, options.uncertain, progress);
    }
    if (result.status == IdentificationStatus::survey_does_not_fit) {
        const std::string text = net_balance_text(net);
        result.message += (text.empty() ? "" : " ") + text;
    }
    result.prior_was_given = options.prior.has_value();
    result.method = to_string(method);
    result.method_reason = reason;
    result.assumptions = assumptions_of(options.uncertain, options.uncertain, result);
    result.trust = trust_of(net, survey, result);
    return result;
}

}  // namespace taut
