// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/observations.hpp"

#include "taut/statics/tensions.hpp"

namespace taut {

Iterate nominal_iterate(const CableNet& net) {
    return {.form = net.nodes(), .deviations = Eigen::VectorXd::Zero(net.interior_edge_count())};
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

Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                     const std::vector<bool>& rejected, double length_std) {
    Observations observations{
        .form = survey.form,
        .weights = Points::Zero(3, net.node_count()),
        .mean = Eigen::VectorXd::Zero(net.interior_edge_count()),
        .variance = Eigen::VectorXd::Constant(net.interior_edge_count(), length_std * length_std)};
    for (const int node : survey.surveyed) {
        if (!rejected[node]) {
            observations.weights.col(node) = noise.col(node).cwiseAbs2().cwiseInverse();
        }
    }
    return observations;
}

}  // namespace taut
