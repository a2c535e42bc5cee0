// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// What one survey leaves uncertain: single lengths, two lengths together, and the tensions.
#include <cmath>
#include <iostream>
#include <random>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

int main() {
    const taut::CableNet net = taut::hypar(6, 6);
    const taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.003};  // m

    // A built net, and a survey of it that misses one target.
    const Eigen::VectorXd deviations =
        taut::draw_length_deviations(prior, 7, 0, net.interior_edge_count());
    const taut::Equilibrium built = taut::EquilibriumSolver(net).solve(
        taut::with_length_deviations(net, deviations), net.nodes());
    const int hidden = net.free_nodes()[14];
    taut::Survey survey;
    survey.form = built.form;
    survey.noise_std = taut::Points::Constant(3, net.node_count(), 0.5e-3);
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0.0, 0.5e-3);
    for (const int node : net.free_nodes()) {
        (node == hidden ? survey.missing : survey.surveyed).push_back(node);
        for (int k = 0; k < 3; ++k) {
            survey.form(k, node) += noise(random);
        }
    }

    // Two edges at the hidden node: where one is longer, the other may be shorter.
    taut::IdentifyOptions options;
    options.prior = prior;
    for (const int edge : net.edges_at(hidden)) {
        if (net.interior_index(edge) >= 0 && options.covariance_of.size() < 2) {
            options.covariance_of.push_back(edge);
        }
    }
    const taut::Identification found = taut::identify(net, survey, options);
    std::cout << "checks: " << to_string(found.trust.verdict()) << '\n';

    int inside = 0;
    for (size_t i = 0; i < found.edges.size(); ++i) {
        const double truth = deviations(static_cast<Eigen::Index>(i));
        inside += found.edges[i].lower <= truth && truth <= found.edges[i].upper ? 1 : 0;
    }
    const Eigen::MatrixXd& covariance = found.length_covariance->covariance;
    // Probabilities of joint events are counted over the posterior samples.
    const Eigen::MatrixXd& drawn = found.draws->length_deviations;
    const auto first = drawn.row(net.interior_index(options.covariance_of[0])).array();
    const auto second = drawn.row(net.interior_index(options.covariance_of[1])).array();
    const auto both = (first > 0.0 && second > 0.0).count();
    const taut::DrawnTension& tension = found.drawn.tensions[options.covariance_of[0]];
    std::cout << inside << " of " << found.edges.size() << " lengths are in their intervals\n"
              << "edges " << options.covariance_of[0] << " and " << options.covariance_of[1]
              << ": std " << 1e3 * std::sqrt(covariance(0, 0)) << " and "
              << 1e3 * std::sqrt(covariance(1, 1)) << " mm, correlation "
              << covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1)) << '\n'
              << "both are too long with "
              << 100.0 * static_cast<double>(both) / static_cast<double>(drawn.cols()) << " %\n"
              << "tension of edge " << tension.edge << ": " << 1e-3 * tension.tension.lower
              << " to " << 1e-3 * tension.tension.upper << " kN, slack with "
              << 100.0 * tension.slack_probability << " %\n";
    return found.trust.verdict() != taut::Trust::Verdict::failed ? 0 : 1;
}
