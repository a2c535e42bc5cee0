// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/processes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/completion.hpp"
#include "identification/mean_function.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// What the processes tell of each edge at one form, and how its uncertainty adds to theirs.
/// @param after the form's distribution; null where the form is known
std::vector<LengthLikelihood> process_likelihoods(const CableNet& net, const LengthModel& model,
                                                  const Eigen::VectorXd& form_deviation,
                                                  const ConditionedForm* after) {
    const LengthEstimates estimates = estimate_lengths(net, model, form_deviation);  // eq. ident
    const Points form = with_free_coordinates(net, model.nominal_form + form_deviation);
    Eigen::VectorXd of_length = Eigen::VectorXd::Zero(net.interior_edge_count());
    Eigen::VectorXd of_extension = of_length;
    if (after != nullptr) {  // (propagation)
        const Eigen::MatrixXd rates =
            mean_gradient(net, model.mean, model.nominal_form, form_deviation) +
            model.processes.mean_gradient(model.input_scales.cwiseProduct(form_deviation)) *
                model.input_scales.asDiagonal();
        of_length = after->variances(rates.transpose());
        of_extension = after->variances((length_gradient(net, form) - rates).transpose());
    }
    const Eigen::VectorXd lengths = edge_lengths(net, form);
    std::vector<LengthLikelihood> result;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double variance = estimates.std(i, 0) * estimates.std(i, 0);
        LengthLikelihood likelihood = without_prior(0.0, model.law.std(), estimates.mean(i, 0),
                                                    std::sqrt(variance + of_length(i)));
        likelihood.slack_from = lengths(edge) - net.unstressed_lengths()(edge);
        likelihood.extension =
            (likelihood.slack_from - estimates.mean(i, 0)) / std::sqrt(variance + of_extension(i));
        result.push_back(likelihood);
    }
    return result;
}

}  // namespace

Identification identify_by_processes(const CableNet& net, const LengthModel& model,
                                     const Survey& survey, const FormDistribution* before) {
    Identification result{.method = "gp"};
    Eigen::VectorXd deviation = free_coordinates(net, survey.form) - model.nominal_form;
    FormDistribution own;
    std::optional<ConditionedForm> after;
    if (survey.is_noisy() || !survey.is_whole()) {
        if (before == nullptr) {
            own = form_before_survey(net, model);  // (form-prior)
        }
        after.emplace(net, before != nullptr ? *before : own, survey, model.nominal_form,
                      default_false_alarm_rate);  // (conditioning), (snooping)
        deviation = after->mean();
        tell_snooping(result, survey, after->snooping(), after->snooping().contradicts_too_many());
    }
    result.law = model.law;
    tell_edges(result, net, std::vector(net.interior_edge_count(), model.law),
               process_likelihoods(net, model, deviation, after ? &*after : nullptr));
    predict_form(result, net, survey, with_free_coordinates(net, model.nominal_form + deviation));
    return result;
}

Identification identify_as_in_paper(const CableNet& net, const LengthModel& model,
                                    const Survey& survey) {
    require_whole(net, survey, "all for a model as in the paper");
    const LengthEstimates estimates =
        estimate_lengths(net, model, free_coordinates(net, survey.form) - model.nominal_form);
    Identification result{.method = "gp", .law = model.law};
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double mean = estimates.mean(i, 0);
        const double std = estimates.std(i, 0);
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = mean,
                                .std = std,
                                .lower = mean - half_interval_95 * std,
                                .upper = mean + half_interval_95 * std,
                                .status = std > unobserved_ratio * model.law.std()
                                              ? EdgeStatus::unobserved
                                              : EdgeStatus::identified});
    }
    predict_form(result, net, survey, survey.form);
    const Eigen::VectorXd measured = edge_lengths(net, survey.form);
    for (IdentifiedEdge& e : result.edges) {
        if (std::ranges::binary_search(result.predicted.slack_edges, e.edge)) {  // (slack-bound)
            e.lower = std::min(e.length_deviation, measured(e.edge) - e.nominal);
            e.upper = std::max(e.length_deviation, model.law.reach());
            e.std = model.law.std();
            e.status = EdgeStatus::slack;
        }
    }
    return result;
}

}  // namespace taut
