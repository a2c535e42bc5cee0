// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/observations.hpp"

#include "taut/statics/tensions.hpp"

namespace taut {

Iterate Iterate::moved(const Iterate& step, double part) const {
    return {.form = form + part * step.form,
            .deviations = deviations + part * step.deviations,
            .loads = loads + part * step.loads,
            .common = common + part * step.common};
}

Iterate nominal_iterate(const CableNet& net, int common_unknowns) {
    return {.form = net.nodes(),
            .deviations = Eigen::VectorXd::Zero(net.interior_edge_count()),
            .loads = Points::Zero(3, net.node_count()),
            .common = Eigen::VectorXd::Zero(common_unknowns)};
}

Points with_noise_floor(const CableNet& net, const Survey& survey) {
    constexpr double exact_part_of_length = 1e-7;
    const double exact = exact_part_of_length * edge_lengths(net, net.nodes()).mean();
    Points noise = Points::Constant(3, net.node_count(), exact);
    if (survey.noise_std.cols() != 0) {
        noise = survey.noise_std.cwiseMax(exact);
    }
    return noise;
}

Observations nothing_observed(const CableNet& net, double length_std, int common_unknowns) {
    const Points none = Points::Zero(3, net.node_count());
    return {
        .form = net.nodes(),
        .weights = none,
        .support_mean = none,
        .support_weights = none,
        .mean = Eigen::VectorXd::Zero(net.interior_edge_count()),
        .variance = Eigen::VectorXd::Constant(net.interior_edge_count(), length_std * length_std),
        .load_mean = none,
        .load_variance = none,
        .common_mean = Eigen::VectorXd::Zero(common_unknowns),
        .tension = Eigen::VectorXd::Zero(net.edge_count()),
        .tension_weights = Eigen::VectorXd::Zero(net.edge_count())};
}

Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                     const std::vector<bool>& rejected, double length_std, int common_unknowns) {
    Observations observations = nothing_observed(net, length_std, common_unknowns);
    observations.form = survey.form;
    for (const int node : survey.surveyed) {
        if (!rejected[node]) {
            observations.weights.col(node) = noise.col(node).cwiseAbs2().cwiseInverse();
        }
    }
    return observations;
}

}  // namespace taut
