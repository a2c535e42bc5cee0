// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/identification.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

void check(const CableNet& net, const LengthModel& model, const Survey& survey) {
    if (model.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(
            fmt::format("the model was trained for the net {}, expected {} ('{}')",
                        model.net_fingerprint, net.fingerprint(), net.name()));
    }
    if (!survey.missing.empty()) {
        throw std::invalid_argument(fmt::format(
            "the survey holds {} of {} free nodes, expected all: node '{}' is the first missing",
            survey.surveyed.size(), net.free_node_count(), net.node_id(survey.missing.front())));
    }
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

LengthEstimates estimate_lengths(const LengthModel& model,
                                 const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    gp::Prediction prediction = model.processes.predict(form_deviations);
    for (Eigen::Index i = 0; i < prediction.std.rows(); ++i) {
        const gp::Process& process = model.processes.processes[static_cast<size_t>(i)];
        if (process.status != gp::FitStatus::fitted) {
            prediction.std.row(i).setConstant(model.law.std());
            continue;
        }
        const double noise = process.hyperparameters.noise_std;
        prediction.std.row(i) = (prediction.std.row(i).array().square() + noise * noise).sqrt();
    }
    return {.mean = std::move(prediction.mean), .std = std::move(prediction.std)};
}

Identification identify_by_processes(const CableNet& net, const LengthModel& model,
                                     const Survey& survey) {
    check(net, model, survey);
    const LengthEstimates estimates =
        estimate_lengths(model, free_coordinates(net, survey.form) - model.nominal_form);
    const Eigen::VectorXd lengths = with_length_deviations(net, estimates.mean.col(0));

    for (const int edge : net.interior_edges()) {
        if (!(lengths(edge) > 0.0)) {
            throw std::runtime_error(fmt::format(
                "the survey gives edge '{}' the unstressed length {:.4g} m: it is not of this net, "
                "or far noisier than what the model was trained on",
                net.edge_id(edge), lengths(edge)));
        }
    }

    Identification result;
    result.method = "gp";
    result.predicted = EquilibriumSolver(net).solve(lengths, survey.form);
    if (!result.predicted.balanced()) {
        throw std::runtime_error(fmt::format(
            "the identified lengths find no equilibrium: {:.4g} N out of balance after {} "
            "iterations",
            result.predicted.out_of_balance, result.predicted.iterations));
    }
    const Eigen::VectorXd measured = edge_lengths(net, survey.form);
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[static_cast<size_t>(i)];
        const double mean = estimates.mean(i, 0);
        const double std = estimates.std(i, 0);
        IdentifiedEdge e{.edge = edge,
                         .nominal = net.unstressed_lengths()(edge),
                         .length_deviation = mean,
                         .std = std,
                         .lower = mean - half_interval_95 * std,
                         .upper = mean + half_interval_95 * std,
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
    const Eigen::MatrixXd differences =
        (result.predicted.form - survey.form)(Eigen::all, survey.surveyed);
    result.residuals = differences.colwise().norm().transpose();
    return result;
}

}  // namespace taut
