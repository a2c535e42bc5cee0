// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "taut/results/result_file.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/study.hpp"

/// Studies without the work of one.
namespace taut::test {

/// A study of which no number agrees with another, made up without sampling or training.
/// @param validation number of validation samples; as many were trained on
/// @param scale of the identified errors; 0 for lengths and forms that are identified exactly
inline Study made_up_study(const CableNet& net, int validation = 5, double scale = 1.0) {
    const Eigen::Index m = net.interior_edge_count();
    const Eigen::Index n = net.free_node_count();
    Study study{.net = net};
    study.settings = {.samples = 2 * validation, .validation = validation, .seed = 7};
    study.data.nominal_form = free_coordinates(net, net.nodes());
    study.data.form_deviations = Eigen::MatrixXd::Zero(3 * n, 2 * validation);
    study.data.length_deviations =
        Eigen::MatrixXd::NullaryExpr(m, 2 * validation, [](Eigen::Index i, Eigen::Index k) {
            return 0.005 *
                   std::sin(1.0 + 1.7 * static_cast<double>(i) + 0.3 * static_cast<double>(k));
        });
    study.data.statuses.assign(2 * validation, EquilibriumStatus::converged);
    study.data.slack_counts.assign(2 * validation, 0);
    study.data.slack_counts.front() = 2;
    study.data.statuses.back() = EquilibriumStatus::iteration_limit;
    for (int k = validation; k < 2 * validation; ++k) {
        study.validation.push_back(k);
    }
    const Eigen::MatrixXd truth = study.data.length_deviations(Eigen::all, study.validation);
    const Eigen::MatrixXd errors =
        Eigen::MatrixXd::NullaryExpr(m, validation, [scale](Eigen::Index i, Eigen::Index k) {
            return 2e-4 * scale * std::cos(2.3 * static_cast<double>(i) + static_cast<double>(k));
        });
    study.model.processes.inputs.resize(3 * n, validation);
    study.estimates = {.mean = truth - errors,
                       .std = Eigen::MatrixXd::Constant(m, validation, 1e-4)};
    for (const char* name : {"gp_as_in_paper", "gp", "balance", "map"}) {
        study.methods.push_back({.name = name,
                                 .surveys = validation,
                                 .errors = length_errors(truth, study.estimates.mean),
                                 .coverage = 0.942,
                                 .form_error = {.mean = 0.00028 * scale}});
    }
    study.methods.back().failed = validation;  // a method that gave no result
    study.methods.back().first_failure = "made to fail";
    study.methods.back().errors = {};
    study.nominal_form_error = Eigen::VectorXd::LinSpaced(n, 0.0003, 0.0119);
    study.identified_form_error = scale * Eigen::VectorXd::LinSpaced(n, 0.00002, 0.00083);
    study.identified_form = net.nodes();
    study.form_errors = {.nominal = summarise(study.nominal_form_error),
                         .identified = summarise(study.identified_form_error)};
    study.mean_form_errors = {
        .nominal = {.max = 0.0123, .min = 0.00021, .mean = 0.0045, .rmse = 0.0051},
        .identified = {.max = 0.00091 * scale,
                       .min = 0.000013 * scale,
                       .mean = 0.00028 * scale,
                       .rmse = 0.00032 * scale}};
    study.seconds = {.sampling = 1.23, .training = 4.56, .identification = 0.789, .total = 6.58};
    return study;
}

/// The same as it comes back from its file.
inline ResultFile saved(const Study& study) {
    return parse_result(study_to_json(study), "results.json");
}

/// An identification of the net, made up: every edge identified, every free node surveyed.
inline ResultFile made_up_identification(const CableNet& net) {
    Identification identification{.method = "gp"};
    for (const int edge : net.interior_edges()) {
        const double deviation = 0.004 * std::sin(1.0 + edge);
        identification.edges.push_back({.edge = edge,
                                        .nominal = net.unstressed_lengths()(edge),
                                        .length_deviation = deviation,
                                        .std = 1e-4,
                                        .lower = deviation - 2e-4,
                                        .upper = deviation + 2e-4});
    }
    identification.edges.front().status = EdgeStatus::slack;
    identification.predicted.form = net.nodes();
    identification.residuals = Eigen::VectorXd::Constant(net.free_node_count(), 3e-4);
    Survey survey{.form = net.nodes(), .surveyed = net.free_nodes(), .missing = {}};
    survey.form.array() += 1e-4;
    return parse_result(identification_to_json(net, survey, identification), "result.json");
}

/// A comparison of two methods at two noises; one of them learns from samples.
inline ResultFile made_up_comparison() {
    return parse_result(
        R"({"format": "taut-comparison", "version": 1, "net": {"name": "a <b>net</b>"},
        "rows": [
        {"method": "gp", "noise": 0.0, "training_samples": 100, "mse": 4e-8, "best_possible_mse": 1e-10},
        {"method": "gp", "noise": 0.0001, "training_samples": 100, "mse": 5e-8, "best_possible_mse": 2e-8},
        {"method": "gp", "noise": 0.0001, "training_samples": 900, "mse": 3e-8, "best_possible_mse": 2e-8},
        {"method": "balance", "noise": 0.0, "training_samples": null, "mse": 1e-24, "best_possible_mse": 1e-10},
        {"method": "balance", "noise": 0.0001, "mse": null, "best_possible_mse": 2e-8}]})",
        "compare.json");
}

}  // namespace taut::test
