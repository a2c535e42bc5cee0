// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "study/error_sums.hpp"
#include "taut/results/control_files.hpp"
#include "taut/results/plan_files.hpp"
#include "taut/results/result_file.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/study.hpp"

/// Results made up without computation.
namespace taut::test {

/// A study in which all numbers differ, made up without sampling or training.
/// @param validation number of validation samples, and of training samples
/// @param scale of the errors; 0 for lengths and forms that are identified exactly
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
                       .std_dev = Eigen::MatrixXd::Constant(m, validation, 1e-4)};
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

/// The study as read back from its file.
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
                                        .std_dev = 1e-4,
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
        {"method": "gp", "noise": 0.0, "training_samples": 100, "surveys": 5, "failed": 0, "mse": 4e-8, "cramer_rao_mse": 1e-10},
        {"method": "gp", "noise": 0.0001, "training_samples": 100, "mse": 5e-8, "cramer_rao_mse": 2e-8},
        {"method": "gp", "noise": 0.0001, "training_samples": 900, "mse": 3e-8, "cramer_rao_mse": 2e-8},
        {"method": "balance", "noise": 0.0, "training_samples": null, "mse": 1e-24, "cramer_rao_mse": 1e-10},
        {"method": "balance", "noise": 0.0001, "mse": null, "cramer_rao_mse": 2e-8}]})",
        "compare.json");
}

/// Simulated jobs, made up. As built, the first trial is 3 mm from the target along its normal,
/// each later one 0.3 mm more; each round leaves a third. In the last round of the last trial the
/// identification fails. Plans on the design break a limit by 5 % in every trial.
inline ResultFile made_up_control(const CableNet& net, int rounds = 2, int trials = 5) {
    std::vector<ControlRecord> records;
    for (const ControlStrategy strategy : {ControlStrategy::truth, ControlStrategy::identified,
                                           ControlStrategy::nominal, ControlStrategy::once}) {
        ControlRecord record{.strategy = strategy, .states = {}};
        const bool is_broken = strategy == ControlStrategy::nominal;
        for (int trial = 0; trial < trials; ++trial) {
            for (int round = 0; round <= rounds; ++round) {
                const double distance = (0.003 + 0.0003 * trial) / std::pow(3.0, round);
                const bool has_failed = strategy == ControlStrategy::identified &&
                                        trial == trials - 1 && round == rounds;
                record.states.push_back({.trial = trial,
                                         .round = round,
                                         .deviation = {.mean = 2.0 * distance,
                                                       .max = 4.0 * distance,
                                                       .normal_mean = 0.8 * distance,
                                                       .normal_max = 3.0 * distance,
                                                       .normal_rmse = distance},
                                         .least_tension = 1400.0 + 10.0 * round,
                                         .most_tension = 9000.0,
                                         .broken = is_broken ? 3 : 0,
                                         .worst_excess = is_broken ? 0.05 : 0.0,
                                         .turned = round == 0 || has_failed ? 0.0 : 0.25 / round,
                                         .has_failed = has_failed});
            }
        }
        records.push_back(record);
    }
    const ControlSettings settings{
        .prior = LengthPrior{}, .least_tension = 1500.0, .rounds = rounds, .trials = trials};
    return parse_result(control_to_json(records, net, settings), "control.json");
}

/// A plan of two crews that turn the first two adjustable edges, one shorter and one longer, made
/// up without a search. As built, every free node is 3 mm above the target and 4 mm beside it; the
/// plan leaves a third of that. Tensions grow with the edge's number from 2 kN, and the last one
/// exceeds its limit.
/// @param draws number of posterior samples; 0: the plan has no uncertainty
inline ResultFile made_up_plan(const CableNet& net, int draws = 200) {
    const int m = net.edge_count();
    const FormTarget target(net, net.nodes());
    Points deviation = 0.003 * target.normals();
    deviation.colwise() += Eigen::Vector3d(0.004, 0.0, 0.0);
    deviation(Eigen::all, net.supports()).setZero();
    CableNetData data = net.data();
    data.nodes += deviation;
    const BuiltNet built{
        .net = CableNet(data), .length_draws = {}, .perturbations = {}, .no_draws_because = ""};
    Limits limits = stroke_limits(net, net.adjustable_edges(), 0.015);
    limits.tension.lower.setConstant(1500.0);
    limits.tension.upper.setConstant(4000.0);
    limits.tension.upper(0) = std::numeric_limits<double>::infinity();
    const int shorter = net.adjustable_edges()[0];
    const int longer = net.adjustable_edges()[1];
    Plan plan{.strokes = {{.edge = shorter, .stroke = -0.00375}, {.edge = longer, .stroke = 0.005}},
              .as_built = deviation_from(target, net, built.net.nodes())};
    plan.form = net.nodes() + deviation / 3.0;
    plan.planned = deviation_from(target, net, plan.form);
    plan.unconstrained = plan.planned;
    plan.normal_std = draws > 0 ? 0.0002 : 0.0;
    plan.form_std.setConstant(3, net.node_count(), draws > 0 ? 0.0003 : 0.0);
    if (draws > 0) {
        plan.form_covariance.assign(net.node_count(), 9e-8 * Eigen::Matrix3d::Identity());
    }
    plan.tensions = Eigen::VectorXd::LinSpaced(m, 2000.0, 4200.0);
    if (draws > 0) {
        plan.tension_lower = plan.tensions.array() - 150.0;
        plan.tension_upper = plan.tensions.array() + 150.0;
    }
    plan.draws = draws;
    if (draws > 0) {
        plan.limit_probability = 0.93;
    }
    plan.no_draws_because = draws > 0 ? "" : "it was made up";
    plan.has_converged = true;
    plan.breaches = {{.index = m - 1, .value = 4200.0, .limit = 4000.0, .probability = 0.0}};
    plan.normal_rmse_of_free_strokes = plan.planned.normal_rmse;
    const TurnOrder order{
        .turnings = {{.edge = shorter, .stroke = -0.00375, .pass = 1, .crew = 1, .step = 0},
                     {.edge = longer, .stroke = 0.005, .pass = 1, .crew = 2, .step = 0}},
        .passes = 1,
        .walk = 1.5,
        .is_safe = false,
        .worst = {.step = 0, .breach = plan.breaches.front()}};
    PlanOptions options;
    options.turn = TurnSize{.pitch = 0.005, .smallest = 0.25};
    const PlannedTurns turns{.options = options,
                             .limits = limits,
                             .plan = plan,
                             .order = order,
                             .suggested_adjustable = {},
                             .crews = 2,
                             .thread = {}};
    const Trust trust;
    return parse_result(
        plan_to_json(
            {.net = &net, .built = &built, .trust = &trust, .target = &target, .turns = &turns}),
        "plan.json");
}

}  // namespace taut::test
