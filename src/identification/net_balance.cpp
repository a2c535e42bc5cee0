// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/net_balance.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {

std::optional<NetImbalance> local_imbalance(const CableNet& net) {
    // Of the mean tension. The rest of a net that was found in equilibrium is far below.
    constexpr double least = 0.1;
    constexpr double balanced = 0.02;
    constexpr double few = 6.0;  // a node drawn in a wrong place, and those next to it
    constexpr double few_of_nodes = 0.05;
    constexpr double most_of_nodes = 0.25;
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
    const double nodes = net.free_node_count();
    const double most = std::min(std::max(few, few_of_nodes * nodes), most_of_nodes * nodes);
    return found.nodes.empty() || moved > most ? std::nullopt : std::optional(std::move(found));
}

std::string to_text(const CableNet& net, const NetImbalance& found) {
    constexpr size_t shown = 6;
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min(shown, found.nodes.size()); ++i) {
        names.push_back(net.node_id(found.nodes[i]));
    }
    const size_t more = found.nodes.size() - names.size();
    return fmt::format(
        "The net as given is in equilibrium but at {} {}{}, where up to {:.2g} N, {:.2g} times the "
        "mean tension, are out of balance.",
        found.nodes.size() == 1 ? "node" : "nodes", fmt::join(names, ", "),
        more > 0 ? fmt::format(" and {} more", more) : "", found.largest, found.share);
}

}  // namespace taut
