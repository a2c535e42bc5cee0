// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/stretch_lengths.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "identification/parameter_spread.hpp"
#include "net/sliding_nodes.hpp"
#include "taut/estimation/edge_status.hpp"

namespace taut {
namespace {

bool is_part(const StretchLength& stretch, int edge) {
    return std::ranges::find(stretch.edges, edge) != stretch.edges.end();
}

}  // namespace

Eigen::MatrixXd covariance_between_nodes(const LinearisedFit& fitted, const Observations& sites,
                                         const std::vector<int>& edges) {
    const StaticsModel& model = fitted.model();
    const int lengths = model.net().interior_edge_count();
    const Eigen::VectorXd blur = model.blur.length_variances(lengths);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(lengths, std::ssize(edges));
    Eigen::VectorXd unseen(std::ssize(edges));  // (own-stiffness): which part is the length's
    for (Eigen::Index k = 0; k < unseen.size(); ++k) {
        const int i = model.numbering().interior_of[edges[static_cast<size_t>(k)]];
        const double own = sites.variance(i) / (sites.variance(i) + blur(i));
        weights(i, k) = own;
        unseen(k) = sites.variance(i) * (1.0 - own);
    }
    const Linearisation::LengthResponse response =
        fitted.linearisation.response_to_lengths(weights);
    const Eigen::MatrixXd rates = model.common.slip_rates(edges);
    const Eigen::MatrixXd cross = rates * response.common;
    Eigen::MatrixXd result = weights.transpose() * response.lengths + cross + cross.transpose() +
                             rates * fitted.covariance.common * rates.transpose();
    result.diagonal() += unseen;
    return result;
}

void take_up_slips(Identification& result, const CableNet& net, const PriorKnowledge& knowledge,
                   const LinearisedFit& fitted, const Observations& sites) {
    const StaticsModel& model = fitted.model();
    const CommonParameters& common = model.common;
    const Eigen::VectorXd designed = model.net().unstressed_lengths() - net.unstressed_lengths();
    for (const PriorKnowledge::StretchTension& tension : knowledge.stretches) {
        const Eigen::MatrixXd covariance = covariance_between_nodes(fitted, sites, tension.edges);
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(net.edge_count());
        weights(tension.edges).setConstant(1.0 / static_cast<double>(tension.edges.size()));
        const double variance = weights.dot(fitted.linearisation.covariances_with(weights));
        result.stretches.push_back({.edges = tension.edges,
                                    .nominal = net.unstressed_lengths()(tension.edges).sum(),
                                    .friction = tension.friction,
                                    .std_dev = std::sqrt(std::max(0.0, covariance.sum())),
                                    .tension_std = std::sqrt(std::max(0.0, variance))});
        for (IdentifiedEdge& edge : result.edges) {
            const auto at = std::ranges::find(tension.edges, edge.edge);
            if (at == tension.edges.end()) {
                continue;
            }
            const auto k = at - tension.edges.begin();
            edge.length_deviation +=
                designed(edge.edge) + common.slip(edge.edge, fitted.iterate.common);
            edge.std_dev = std::sqrt(std::max(0.0, covariance(k, k)));
            edge.lower = edge.length_deviation - half_interval_95 * edge.std_dev;
            edge.upper = edge.length_deviation + half_interval_95 * edge.std_dev;
            if (edge.status != EdgeStatus::slack) {
                edge.status = status_of(
                    std_before(result, edge.edge, result.length_prior.std_dev()), edge.std_dev);
            }
        }
    }
}

void set_stretch_means(Identification& result, const CableNet& net) {
    if (result.stretches.empty()) {
        return;
    }
    Eigen::VectorXd deviations = perturbation_of(net, result.uncertain).adjustable;
    for (const IdentifiedEdge& one : result.edges) {
        deviations(one.edge) = one.length_deviation;
    }
    for (const BoundaryOutlier& one : result.boundary_outliers) {
        if (one.kind == BoundaryOutlier::Kind::adjustable_edge) {
            deviations(one.index) += one.deviation.x();
        }
    }
    for (StretchLength& stretch : result.stretches) {
        stretch.length_deviation = deviations(stretch.edges).sum();
        stretch.tension = result.tensions.size() > 0 ? result.tensions(stretch.edges).mean() : 0.0;
    }
}

std::string edge_or_cable(const CableNet& net, int edge) {
    const std::vector<int> stretch = stretch_of(net, edge);
    return stretch.size() == 1 ? net.edge_id(edge)
                               : fmt::format("{} or another of the cable that slides from {} to {}",
                                             net.edge_id(edge), net.edge_id(stretch.front()),
                                             net.edge_id(stretch.back()));
}

double std_before(const Identification& result, int edge, double prior_std) {
    const auto slip = std::ranges::find_if(result.uncertain, [](const ParameterEstimate& one) {
        return one.parameter.kind == UncertainParameter::Kind::slip;
    });
    const bool slides = std::ranges::any_of(
        result.stretches, [&](const StretchLength& one) { return is_part(one, edge); });
    return slides && slip != result.uncertain.end() ? std::hypot(prior_std, slip->parameter.std_dev)
                                                    : prior_std;
}

}  // namespace taut
