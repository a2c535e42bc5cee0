// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/net_balance.hpp"

#include <algorithm>

#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {

std::optional<NetImbalance> local_imbalance(const CableNet& net) {
    // Of the mean tension. The rest of a net that was found in equilibrium is far below.
    constexpr double least = 0.1;
    constexpr double balanced = 0.02;
    constexpr double few = 4.0;
    constexpr double few_of_nodes = 0.05;
    const double mean = imbalance(net, net.unstressed_lengths(), net.nodes()).mean_tension;
    if (!(mean > 0.0)) {
        return std::nullopt;
    }
    const Eigen::VectorXd forces =
        out_of_balance_forces(net, net.unstressed_lengths(), net.nodes());
    NetImbalance found;
    double moved = 0.0;  // nodes that are not in equilibrium
    for (Eigen::Index i = 0; i < net.free_node_count(); ++i) {
        const double force = forces.segment<3>(3 * i).norm();
        moved += force > balanced * mean ? 1.0 : 0.0;
        if (force > least * mean) {
            found.nodes.push_back(net.free_nodes()[static_cast<size_t>(i)]);
            found.largest = std::max(found.largest, force);
        }
    }
    found.share = found.largest / mean;
    const double most = std::max(few, few_of_nodes * net.free_node_count());
    return found.nodes.empty() || moved > most || moved == net.free_node_count()
               ? std::nullopt
               : std::optional(std::move(found));
}

}  // namespace taut
