// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/potential_pull.hpp"

#include <vector>

namespace taut {
namespace {

/// Of all edges that carry something (m).
std::vector<EdgeRates> edge_rates(const StaticsModel& model, const Iterate& at) {
    std::vector<EdgeRates> rates(model.slack.size());
    for (int e = 0; e < model.net().edge_count(); ++e) {
        if (!model.slack[e]) {
            rates[e] = model.rates(e, at);
        }
    }
    return rates;
}

/// Adds the misfits of force measurements, (force-measurement).
void add_forces(const StaticsModel& model, const Observations& y, const Iterate& at,
                const std::vector<EdgeRates>& rates, PotentialPull& pull) {
    for (int e = 0; e < model.net().edge_count(); ++e) {
        if (model.slack[e] || !(y.tension_weights(e) > 0.0)) {
            continue;
        }
        const EdgeRates& edge = rates[e];
        const auto [s, t] = model.net().edges()[e];
        const double misfit = y.tension_weights(e) *
                              (y.tension(e) - edge.tension - y.tension_bias.row(e).dot(at.common));
        pull.places.col(s) += misfit * edge.axial * edge.direction;
        pull.places.col(t) -= misfit * edge.axial * edge.direction;
        pull.lengths(e) += misfit * edge.by_length;
        for (int k = 0; k < model.common.count(); ++k) {
            pull.common(k) +=
                misfit * (edge.tension_by(model.common_variation(e, k, at)) + y.tension_bias(e, k));
        }
    }
}

/// Adds what lengths and common parameters do to the form, by the multipliers.
void add_balance_of_edges(const StaticsModel& model, const Iterate& at,
                          const std::vector<EdgeRates>& rates, PotentialPull& pull) {
    for (int e = 0; e < model.net().edge_count(); ++e) {
        if (model.slack[e]) {
            continue;
        }
        const auto [s, t] = model.net().edges()[e];
        const Eigen::Vector3d relative = pull.multipliers.col(s) - pull.multipliers.col(t);
        pull.lengths(e) -= rates[e].length_rate().dot(relative);
        const Eigen::Vector3d reaction = rates[e].stiffness() * relative;
        pull.places.col(s) -= reaction;
        pull.places.col(t) += reaction;
        for (int k = 0; k < model.common.count(); ++k) {
            pull.common(k) -= rates[e].force_by(model.common_variation(e, k, at)).dot(relative);
        }
    }
}

/// The same of common parameters by loads, the frame and elastic supports.
/// @param of_frame misfits of the places that move with the frame (3 x n) [1/m]
void add_balance_of_nodes(const StaticsModel& model, const Iterate& at, const Points& of_frame,
                          PotentialPull& pull) {
    const CableNet& net = model.net();
    const CommonParameters& common = model.common;
    const double factor = common.support_factor(at.common);
    const Points springs = model.designed_elastic_forces(at) - at.loads;
    for (int k = 0; k < common.count(); ++k) {
        if (const Points& rate = common.load_rate(k); rate.cols() > 0) {
            pull.common(k) += rate.cwiseProduct(pull.multipliers).sum();
        }
        for (const int node : net.supports()) {
            pull.common(k) += common.support_rate(k, node).dot(of_frame.col(node));
        }
        for (const ElasticSupport& support : net.elastic_supports()) {
            pull.common(k) -=
                factor * (common.support_stiffness_rate(k) * springs.col(support.node) -
                          common.place_load_rate(k, support.node))
                             .dot(pull.multipliers.col(support.node));
        }
    }
}

/// Adds what other surveys show, (epoch-evidence).
void add_evidence(const CableNet& net, const Observations& y, const Iterate& at,
                  PotentialPull& pull) {
    if (!y.evidence) {
        return;
    }
    const Eigen::VectorXd misfit =
        y.evidence_pull - y.evidence->information * at.lengths_and_common(y.evidence_pull.size());
    const auto count = std::ssize(net.interior_edges());
    pull.lengths(net.interior_edges()) += misfit.head(count);
    pull.common.head(misfit.size() - count) += misfit.tail(misfit.size() - count);
}

}  // namespace

PotentialPull potential_pull(const StaticsModel& model, const Observations& observations,
                             const FormOfModel& form, const Iterate& at) {
    const CableNet& net = model.net();
    const Observations& y = observations;
    const Points measured = y.weighted(y.form - at.form);
    const Points of_supports =
        y.support_weights.cwiseProduct(y.support_mean - model.support_deviations(at));
    const std::vector<EdgeRates> rates = edge_rates(model, at);
    PotentialPull pull{.lengths = Eigen::VectorXd::Zero(net.edge_count()),
                       .common = y.common_mean - at.common,
                       .places = measured + of_supports,
                       .multipliers = {}};
    add_forces(model, y, at, rates, pull);
    pull.multipliers = form.solve(pull.places);
    add_balance_of_edges(model, at, rates, pull);
    add_balance_of_nodes(model, at,
                         model.are_supports_uncertain() ? Points(-of_supports) : measured, pull);
    add_evidence(net, y, at, pull);
    if (model.are_supports_uncertain()) {
        for (const int node : net.supports()) {
            for (int k = 0; k < model.common.count(); ++k) {  // places hold the frame's motion
                pull.common(k) += model.common.support_rate(k, node).dot(pull.places.col(node));
            }
        }
    }
    return pull;
}

}  // namespace taut
