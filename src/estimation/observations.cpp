// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/observations.hpp"

#include <utility>

#include "numerics/symmetric_blocks.hpp"
#include "survey/covariance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

Eigen::Matrix3d Observations::weight(int node) const {
    return symmetric_block(weights, cross_weights, node);
}

Eigen::Matrix3d Observations::load_covariance(int node) const {
    return symmetric_block(load_variance, cross_load_variance, node);
}

void Observations::scale_weight(int node, double factor) {
    weights.col(node) *= factor;
    if (cross_weights.cols() > 0) {
        cross_weights.col(node) *= factor;
    }
}

void Observations::scale_stds(int node, const Eigen::Array3d& factors) {
    weights.col(node).array() /= factors.square();
    if (cross_weights.cols() > 0) {
        cross_weights.col(node).array() /= Eigen::Array3d(
            factors.x() * factors.y(), factors.x() * factors.z(), factors.y() * factors.z());
    }
}

Points Observations::weighted(const Points& errors) const {
    return symmetric_products(weights, cross_weights, errors);
}

double Observations::squared_norm(const Points& errors) const {
    return cross_weights.cols() > 0 ? weighted(errors).cwiseProduct(errors).sum()
                                    : weights.cwiseProduct(errors.cwiseAbs2()).sum();
}

void Observations::set_evidence(std::shared_ptr<const LengthEvidence> of_others) {
    evidence = std::move(of_others);
    evidence_pull = evidence ? evidence->pull : Eigen::VectorXd();
}

Eigen::VectorXd Iterate::lengths_and_common(Eigen::Index size) const {
    Eigen::VectorXd result(size);
    result << deviations, common.head(size - deviations.size());
    return result;
}

Iterate Iterate::moved(const Iterate& step, double part) const {
    return {.form = form + part * step.form,
            .deviations = deviations + part * step.deviations,
            .loads = loads + part * step.loads,
            .common = common + part * step.common};
}

Iterate nominal_iterate(const CableNet& net, int common_parameters) {
    return {.form = net.nodes(),
            .deviations = Eigen::VectorXd::Zero(net.interior_edge_count()),
            .loads = Points::Zero(3, net.node_count()),
            .common = Eigen::VectorXd::Zero(common_parameters)};
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

Observations nothing_observed(const CableNet& net, double length_std, int common_parameters) {
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
        .common_mean = Eigen::VectorXd::Zero(common_parameters),
        .tension = Eigen::VectorXd::Zero(net.edge_count()),
        .tension_weights = Eigen::VectorXd::Zero(net.edge_count()),
        .tension_bias = Eigen::MatrixXd::Zero(net.edge_count(), common_parameters),
        .evidence = nullptr,
        .evidence_pull = {}};
}

Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                     const std::vector<bool>& rejected, double length_std, int common_parameters) {
    Observations observations = nothing_observed(net, length_std, common_parameters);
    observations.form = survey.form;
    if (survey.noise_correlations.cols() > 0) {
        observations.cross_weights = Points::Zero(3, net.node_count());
    }
    for (const int node : survey.surveyed) {
        if (!rejected[node]) {
            observations.weights.col(node) = noise.col(node).cwiseAbs2().cwiseInverse();
            const Eigen::Vector3d correlations = survey.correlations_of(node);
            if (!correlations.isZero(0.0)) {
                const Eigen::Matrix3d S =
                    weight_of({.std_dev = noise.col(node), .correlations = correlations});
                observations.weights.col(node) = S.diagonal();
                observations.cross_weights.col(node) << S(0, 1), S(0, 2), S(1, 2);
            }
        }
    }
    return observations;
}

}  // namespace taut
