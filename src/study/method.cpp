// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/method.hpp"

#include <memory>

#include "taut/identification/force_balance.hpp"
#include "taut/identification/form_distribution.hpp"
#include "taut/identification/maximum_a_posteriori.hpp"

namespace taut {
namespace {

Identification identify_as_in_paper(const CableNet& net, const LengthModel& model,
                                    const Survey& survey) {
    const LengthEstimates estimates =
        estimate_lengths(net, model, free_coordinates(net, survey.form) - model.nominal_form);
    Identification result{.method = "gp_as_in_paper"};
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double mean = estimates.mean(i, 0);
        const double std = estimates.std(i, 0);
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = mean,
                                .std = std,
                                .lower = mean - half_interval_95 * std,
                                .upper = mean + half_interval_95 * std});
    }
    result.predicted = EquilibriumSolver(net).solve(
        with_length_deviations(net, estimates.mean.col(0)), survey.form);
    return result;
}

}  // namespace

Method method_as_in_paper(const CableNet& net, const LengthModel& model) {
    return {.name = "gp_as_in_paper",
            .training_samples = model.training_count(),
            .needs_all_nodes = true,
            .uses_all_threads = true,
            .identify = [&net, &model](const Survey& survey) {
                return identify_as_in_paper(net, model, survey);
            }};
}

Method method_by_processes(const CableNet& net, const LengthModel& model) {
    return {.name = "gp",
            .training_samples = model.training_count(),
            .uses_all_threads = true,
            .identify = [&net, &model,
                         before = std::make_shared<FormDistribution>()](const Survey& survey) {
                if (before->mean.size() == 0) {
                    *before = form_before_survey(net, model);
                }
                return identify_by_processes(net, model, survey, &*before);
            }};
}

Method method_by_force_balance(const CableNet& net, const LengthLaw& law) {
    return {
        .name = "balance", .needs_all_nodes = true, .identify = [&net, law](const Survey& survey) {
            return identify_by_force_balance(net, survey, law);
        }};
}

Method method_by_maximum_a_posteriori(const CableNet& net, const LengthLaw& law) {
    return {.name = "map", .identify = [&net, law](const Survey& survey) {
                return identify_by_maximum_a_posteriori(net, survey, law);
            }};
}

}  // namespace taut
