// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/identification.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "estimation/data_snooping.hpp"
#include "estimation/observations.hpp"
#include "identification/form_conditioning.hpp"
#include "identification/mean_function.hpp"
#include "identification/outcome.hpp"
#include "taut/estimation/length_posterior.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

void check_lengths(const CableNet& net, const Eigen::VectorXd& lengths) {
    for (const int edge : net.interior_edges()) {
        if (!(lengths(edge) > 0.0)) {
            throw std::runtime_error(fmt::format(
                "the survey gives edge '{}' the unstressed length {:.4g} m: it is not of this net, "
                "or far noisier than what the model was trained on",
                net.edge_id(edge), lengths(edge)));
        }
    }
}

bool is_whole(const CableNet& net, const Survey& survey) {
    return static_cast<int>(survey.surveyed.size()) == net.free_node_count();
}

int first_missing(const CableNet& net, const Survey& survey) {
    return *std::ranges::mismatch(net.free_nodes(), survey.surveyed).in1;
}

/// Eq. ident at the surveyed form.
Identification identify_as_in_paper(const CableNet& net, const LengthModel& model,
                                    const Survey& survey) {
    if (!is_whole(net, survey)) {
        throw std::invalid_argument(fmt::format(
            "the survey holds {} of {} free nodes, expected all for a model as in the paper: node "
            "'{}' is the first missing",
            survey.surveyed.size(), net.free_node_count(),
            net.node_id(first_missing(net, survey))));
    }
    const LengthEstimates estimates =
        estimate_lengths(net, model, free_coordinates(net, survey.form) - model.nominal_form);
    check_lengths(net, with_length_deviations(net, estimates.mean.col(0)));

    Identification result;
    result.method = "gp";
    predict_form(result, net, survey, estimates.mean.col(0), survey.form);
    const Eigen::VectorXd measured = edge_lengths(net, survey.form);
    const double bound = model.law.kind == LengthLaw::Kind::uniform
                             ? model.law.scale
                             : std::numeric_limits<double>::infinity();
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double mean = estimates.mean(i, 0);
        const double std = estimates.std(i, 0);
        IdentifiedEdge e{.edge = edge,
                         .nominal = net.unstressed_lengths()(edge),
                         .length_deviation = mean,
                         .std = std,
                         // Within the law's bounds, but for an estimate that lies beyond them.
                         .lower = std::min(mean, std::max(mean - half_interval_95 * std, -bound)),
                         .upper = std::max(mean, std::min(mean + half_interval_95 * std, bound)),
                         .status = std > unobserved_ratio * model.law.std()
                                       ? EdgeStatus::unobserved
                                       : EdgeStatus::identified};
        if (std::ranges::binary_search(result.predicted.slack_edges, edge)) {
            // No shorter than it was measured, and no longer than the law lets it be.
            e.lower = measured(edge) - e.nominal;
            e.upper = std::max(e.lower, model.law.reach());
            e.length_deviation = std::clamp(mean, e.lower, e.upper);
            e.std = model.law.std();
            e.status = EdgeStatus::slack;
        }
        result.edges.push_back(e);
    }
    return result;
}

bool is_exact_and_whole(const CableNet& net, const Survey& survey) {
    return is_whole(net, survey) &&
           (survey.noise_std.cols() == 0 ||
            survey.noise_std(Eigen::all, survey.surveyed).maxCoeff() == 0.0);
}

/// What the processes tell of each edge at one form, and how its uncertainty adds to theirs.
/// @param after the form's distribution; null where the form is known
std::vector<LengthLikelihood> process_likelihoods(const CableNet& net, const LengthModel& model,
                                                  const Eigen::VectorXd& form_deviation,
                                                  const ConditionedForm* after) {
    const LengthEstimates estimates = estimate_lengths(net, model, form_deviation);
    const Points form = with_free_coordinates(net, model.nominal_form + form_deviation);
    Eigen::VectorXd of_length = Eigen::VectorXd::Zero(net.interior_edge_count());
    Eigen::VectorXd of_extension = of_length;
    if (after != nullptr) {
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

/// Asks the processes at the form that the survey, the law and the linearised statics tell.
Identification identify_conditionally(const CableNet& net, const LengthModel& model,
                                      const FormDistribution* before, const Survey& survey) {
    Identification result;
    result.method = "gp";
    Eigen::VectorXd deviation = free_coordinates(net, survey.form) - model.nominal_form;
    FormDistribution own;
    std::optional<ConditionedForm> after;
    if (!is_exact_and_whole(net, survey)) {
        const bool is_noisy = survey.noise_std.cols() > 0 &&
                              survey.noise_std(Eigen::all, survey.surveyed).maxCoeff() > 0.0;
        result.outlier_threshold =
            outlier_threshold(is_noisy ? default_false_alarm_rate : 0.0, survey.surveyed.size());
        if (before == nullptr) {
            own = form_before_survey(net, model);
        }
        after.emplace(net, before != nullptr ? *before : own, survey, model.nominal_form,
                      reckoned_noise(net, survey), result.outlier_threshold);
        deviation = after->mean();
        result.outliers = after->outliers();
        result.noise_ratio = after->noise_ratio();
        if (!after->fits()) {
            result.status = IdentificationStatus::survey_does_not_fit;
        }
    }
    complete(result, net, survey, model.law,
             process_likelihoods(net, model, deviation, after ? &*after : nullptr),
             with_free_coordinates(net, model.nominal_form + deviation));
    return result;
}

}  // namespace

std::string_view to_string(EdgeStatus status) {
    switch (status) {
        case EdgeStatus::identified:
            return "identified";
        case EdgeStatus::slack:
            return "slack";
        case EdgeStatus::unobserved:
            return "unobserved";
    }
    return "unknown";
}

std::string_view to_string(IdentificationStatus status) {
    switch (status) {
        case IdentificationStatus::converged:
            return "converged";
        case IdentificationStatus::iteration_limit:
            return "iteration limit";
        case IdentificationStatus::survey_does_not_fit:
            return "survey does not fit";
    }
    return "unknown";
}

LengthEstimates estimate_lengths(const CableNet& net, const LengthModel& model,
                                 const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    gp::Prediction prediction =
        model.processes.predict(model.input_scales.asDiagonal() * form_deviations);
    const Eigen::MatrixXd means = mean_values(net, model.mean, model.nominal_form, form_deviations);
    for (Eigen::Index i = 0; i < prediction.std.rows(); ++i) {
        const gp::Process& process = model.processes.processes[i];
        if (process.status != gp::FitStatus::fitted) {
            prediction.std.row(i).setConstant(model.law.std());
            continue;
        }
        const double noise = process.hyperparameters.noise_std;
        prediction.mean.row(i) += means.row(i);
        prediction.std.row(i) = (prediction.std.row(i).array().square() + noise * noise).sqrt();
    }
    return {.mean = std::move(prediction.mean), .std = std::move(prediction.std)};
}

Identification identify_by_processes(const CableNet& net, const LengthModel& model,
                                     const Survey& survey, const FormDistribution* before) {
    if (model.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the net {}, expected {} ('{}')",
                        model.net_fingerprint, net.fingerprint(), net.name()));
    }
    check_survey(net, survey);
    return model.as_in_paper() ? identify_as_in_paper(net, model, survey)
                               : identify_conditionally(net, model, before, survey);
}

}  // namespace taut
