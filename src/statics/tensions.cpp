// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/tensions.hpp"

#include "statics/arguments.hpp"
#include "statics/edge_state.hpp"
#include "statics/elastic_stretch.hpp"

namespace taut {

Eigen::VectorXd edge_lengths(const CableNet& net, const Eigen::Ref<const Points>& form) {
    check_form("form", net.node_count(), form);
    Eigen::VectorXd lengths(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        lengths(e) = (form.col(s) - form.col(t)).norm();
    }
    return lengths;
}

Eigen::VectorXd tensions_of(const CableNet& net,
                            const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                            const Eigen::Ref<const Points>& form) {
    const auto states = edge_states(net, unstressed_lengths, form);
    Eigen::VectorXd result(net.edge_count());
    std::ranges::transform(states, result.begin(), &EdgeState::tension);
    return result;
}

std::vector<int> slack_edges(const CableNet& net,
                             const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                             const Eigen::Ref<const Points>& form) {
    const auto states = edge_states(net, unstressed_lengths, form);
    std::vector<int> result;
    for (size_t e = 0; e < states.size(); ++e) {
        if (!states[e].carries()) {
            result.push_back(static_cast<int>(e));
        }
    }
    return result;
}

Eigen::VectorXd mean_weights(const CableNet& net) {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        weights(e) = net.is_strut(e) ? 0.0 : 1.0;
    }
    const double count = weights.sum();
    return count > 0.0 ? Eigen::VectorXd(weights / count)
                       : Eigen::VectorXd::Constant(net.edge_count(), 1.0 / net.edge_count());
}

Eigen::VectorXd elastic_stretches(const CableNet& net) {
    const auto states = edge_states(net, net.unstressed_lengths(), net.nodes());
    Eigen::VectorXd result(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        result(e) = states[e].sags
                        ? states[e].tension * net.unstressed_lengths()(e) / net.axial_stiffness()(e)
                        : states[e].extension;
    }
    return result;
}

double mean_stretch(const CableNet& net) {
    return mean_weights(net).dot(elastic_stretches(net).cwiseMax(0.0));
}

}  // namespace taut
