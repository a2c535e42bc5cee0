// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/processes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gp/gradient_weights.hpp"
#include "identification/completion.hpp"
#include "identification/form_conditioning.hpp"
#include "identification/form_prior.hpp"
#include "identification/mean_function.hpp"
#include "numerics/dense.hpp"
#include "numerics/parallel.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Derivatives along the prior's directions, one column an edge, of those with respect to the
/// coordinates.
Eigen::MatrixXd along_directions(const FormPrior& prior, const EdgeGradient& gradient) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(prior.directions.rows(), gradient.rows());
    parallel_for(Eigen::Index{0}, gradient.rows(), [&](Eigen::Index edge) {
        for (EdgeGradient::InnerIterator at(gradient, edge); at; ++at) {
            result.col(edge) += at.value() * prior.directions.col(at.col());
        }
    });
    return result;
}

/// How the uncertainty of the form adds to that of the processes, (propagation).
struct FormUncertainty {
    Eigen::VectorXd of_length;     ///< variance of each length by it (m_I) [m2]
    Eigen::VectorXd of_extension;  ///< of what the edge is longer than that (m_I) [m2]
};

FormUncertainty form_uncertainty(const CableNet& net, const LengthModel& model,
                                 const FormPrior& prior, const Points& form,
                                 const Eigen::VectorXd& form_deviation,
                                 const ConditionedForm& after) {
    const Eigen::MatrixXd lengths = along_directions(prior, length_gradient(net, form));
    // Of the processes: the sum over training inputs x_i of a_i (x - x_i), along the directions.
    const Eigen::VectorXd input = model.input_scales.cwiseProduct(form_deviation);
    const Eigen::MatrixXd weights = gp::gradient_weights(model.processes, input);
    const Eigen::VectorXd input_along = prior.directions * model.input_scales.cwiseProduct(input);
    Eigen::MatrixXd rates = input_along * weights.colwise().sum() - product(prior.inputs, weights);
    rates += lengths * mean_rates(net, model.mean, model.nominal_form).asDiagonal();
    return {.of_length = after.variances_along(rates),
            .of_extension = after.variances_along(lengths - rates)};
}

/// Likelihoods of the lengths by the processes at one form, with its uncertainty added to theirs.
/// @param estimates at that form
/// @param after the form's distribution by `prior`; null where the form is known
std::vector<LengthLikelihood> process_likelihoods(const CableNet& net, const LengthModel& model,
                                                  const FormPrior& prior,
                                                  const LengthEstimates& estimates,
                                                  const Eigen::VectorXd& form_deviation,
                                                  const ConditionedForm* after) {
    const Points form = with_free_coordinates(net, model.nominal_form + form_deviation);
    FormUncertainty uncertainty{.of_length = Eigen::VectorXd::Zero(net.interior_edge_count()),
                                .of_extension = Eigen::VectorXd::Zero(net.interior_edge_count())};
    if (after != nullptr) {
        uncertainty = form_uncertainty(net, model, prior, form, form_deviation, *after);
    }
    const Eigen::VectorXd lengths = edge_lengths(net, form);
    std::vector<LengthLikelihood> result;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double variance = estimates.std_dev(i, 0) * estimates.std_dev(i, 0);
        LengthLikelihood likelihood =
            without_prior(0.0, model.prior.std_dev(), estimates.mean(i, 0),
                          std::sqrt(variance + uncertainty.of_length(i)));
        likelihood.slack_from = lengths(edge) - net.unstressed_lengths()(edge);
        likelihood.extension = net.can_be_slack(edge)
                                   ? (likelihood.slack_from - estimates.mean(i, 0)) /
                                         std::sqrt(variance + uncertainty.of_extension(i))
                                   : std::numeric_limits<double>::infinity();
        result.push_back(likelihood);
    }
    return result;
}

}  // namespace

Identification identify_by_processes(const CableNet& net, const LengthModel& model,
                                     const Survey& survey, const LengthEstimates* at_survey) {
    Identification result{.method = "gp"};
    Eigen::VectorXd deviation = free_coordinates(net, survey.form) - model.nominal_form;
    std::optional<ConditionedForm> after;
    FormPrior made;  // of a large net, whose model keeps none
    const FormPrior& prior = model.form_prior.mean.size() > 0 ? model.form_prior : made;
    if (survey.is_noisy() || !survey.is_whole()) {
        if (&prior == &made) {
            made = form_prior_of(net, model, model.form_deviations());
            made.inputs = inputs_along_directions(model, made);
        }
        after.emplace(net, prior, survey, model.nominal_form,
                      default_false_alarm_rate);  // (conditioning), (snooping)
        deviation = after->mean();
        set_snooping(result, survey, after->hypotheses(), after->outliers(),
                     after->hypotheses().contradicts_too_many(Hypotheses::Family::targets));
    }
    const LengthEstimates estimates = at_survey != nullptr && !after
                                          ? *at_survey
                                          : estimate_lengths(net, model, deviation);  // eq. ident
    result.length_prior = model.prior;
    set_edges(
        result, net, std::vector(net.interior_edge_count(), model.prior),
        process_likelihoods(net, model, prior, estimates, deviation, after ? &*after : nullptr));
    predict_form(result, net, survey, with_free_coordinates(net, model.nominal_form + deviation));
    return result;
}

Identification identify_as_in_paper(const CableNet& net, const LengthModel& model,
                                    const Survey& survey, const LengthEstimates* at_survey) {
    require_whole(net, survey, "all for a model as in the paper");
    const LengthEstimates estimates =
        at_survey != nullptr
            ? *at_survey
            : estimate_lengths(net, model, free_coordinates(net, survey.form) - model.nominal_form);
    Identification result{.method = "gp", .length_prior = model.prior};
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double mean = estimates.mean(i, 0);
        const double std_dev = estimates.std_dev(i, 0);
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = mean,
                                .std_dev = std_dev,
                                .lower = mean - half_interval_95 * std_dev,
                                .upper = mean + half_interval_95 * std_dev,
                                .status = status_of(model.prior.std_dev(), std_dev)});
    }
    predict_form(result, net, survey, survey.form);
    const Eigen::VectorXd measured = edge_lengths(net, survey.form);
    for (IdentifiedEdge& e : result.edges) {
        if (std::ranges::binary_search(result.predicted.slack_edges, e.edge)) {  // (slack-bound)
            e.lower = std::min(e.length_deviation, measured(e.edge) - e.nominal);
            e.upper = std::max(e.length_deviation, model.prior.reach());
            e.std_dev = model.prior.std_dev();
            e.status = EdgeStatus::slack;
        }
    }
    return result;
}

}  // namespace taut
