// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/under_prior.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "estimation/perturbed_draws.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/force_balance.hpp"
#include "identification/identify_options.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/processes.hpp"
#include "numerics/parallel.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

/// A model for the net and the prior, on samples drawn now.
LengthModel trained_model(const CableNet& net, const LengthPrior& prior,
                          const std::vector<UncertainParameter>& uncertain, int samples,
                          const Progress& progress) {
    const Sampler sampler(net, prior, /*seed=*/1, uncertain);
    const DataSet data = draw_samples(sampler, samples, progress);
    return train_model(net, data, data.converged_in(0, data.size()), {}, progress);
}

std::string how_text(const LengthModel& model, bool is_given, const Survey& survey) {
    std::string text = fmt::format("Gaussian processes trained on {} samples of {}{}",
                                   model.training_count(), to_string(model.prior),
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

Identification identify_by(IdentificationMethod method, const CableNet& net, const Survey& survey,
                           const AssumedPrior& prior, const LengthModel* model,
                           const IdentifyOptions& options, const Progress& progress) {
    Identification result;
    switch (method) {
        case IdentificationMethod::balance:
            result = identify_by_force_balance(net, survey, prior.prior);
            result.description = fmt::format("force balance at the surveyed form, lengths {}",
                                             to_string(prior.prior));
            break;
        case IdentificationMethod::map: {
            Given given(prior.prior, options.uncertain, options.forces);
            given.hyperprior = prior.around;
            given.has_trend = prior.has_trend;
            result =
                identify_by_maximum_a_posteriori(net, survey, given, {}, prior.wanted, progress);
            result.description = fmt::format("maximum a posteriori under the statics, lengths {}",
                                             to_string(prior.prior));
            break;
        }
        case IdentificationMethod::gp:
            result = identify_by_model(net, survey, *model);
            result.description = how_text(*model, options.model != nullptr, survey);
            break;
    }
    return result;
}

}  // namespace

PosteriorSettings wanted_by(const CableNet& net, const IdentifyOptions& options) {
    return {.count = draws_wanted(net, options),
            .seed = options.seed,
            .covariance_of = options.covariance_of};
}

Identification identify_under_prior(IdentificationMethod method, const CableNet& net,
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

}  // namespace taut
