// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/net_balance.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;

struct NetImbalance {
    std::vector<int> nodes;  ///< free ones, ascending
    double largest = 0.0;    ///< force out of balance at one of them [N]
    double share = 0.0;      ///< of the mean tension
};

/// Elastic supports may be given where they stand without load.
std::optional<NetImbalance> local_imbalance(const CableNet& as_given) {
    if (!as_given.sliding_nodes().empty()) {
        return std::nullopt;  // lengths as marked are not those of the form
    }
    const CableNet net = with_supports_in_balance(as_given);
    // Of the mean tension. The rest of a net that was found in equilibrium is far below.
    constexpr double least = 0.1;
    constexpr double balanced = 0.02;
    constexpr double few = 6.0;  // a node drawn in a wrong place, and those next to it
    constexpr double few_of_nodes = 0.05;
    constexpr double most_of_nodes = 0.25;
    const double mean = imbalance_of(net, net.unstressed_lengths(), net.nodes()).mean_tension;
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

/// Whether the survey contradicts something at a node or at those next to it.
bool is_contradicted_near(const CableNet& net, const Identification& result, int node) {
    const std::span<const int> neighbours = net.neighbours(node);
    const auto is_near = [&](int other) {
        return other == node || std::ranges::find(neighbours, other) != neighbours.end();
    };
    const auto is_edge_near = [&](int edge) {
        return std::ranges::any_of(net.edges()[static_cast<size_t>(edge)], is_near);
    };
    return std::ranges::any_of(result.outliers, is_near, &Outlier::node) ||
           std::ranges::any_of(result.length_outliers, is_edge_near, &LengthOutlier::edge) ||
           std::ranges::any_of(result.boundary_outliers, [&](const BoundaryOutlier& one) {
               return one.kind == BoundaryOutlier::Kind::support ? is_near(one.index)
                                                                 : is_edge_near(one.index);
           });
}

}  // namespace

std::string net_balance_text(const CableNet& net) {
    const std::optional<NetImbalance> found = local_imbalance(net);
    return found ? to_text(net, *found) : std::string();
}

std::optional<Trust::Finding> net_balance_finding(const CableNet& net, const Identification& result,
                                                  Verdict of_all_else) {
    const std::optional<NetImbalance> found = local_imbalance(net);
    if (!found) {
        return std::nullopt;
    }
    const bool is_contradicted =
        of_all_else != Verdict::passed && std::ranges::any_of(found->nodes, [&](int node) {
            return is_contradicted_near(net, result, node);
        });
    Trust::Finding finding{
        .kind = Trust::Finding::Kind::net_balance,
        .severity = is_contradicted ? Verdict::failed : std::min(of_all_else, Verdict::doubtful),
        .value = found->share,
        .reason =
            to_text(net, *found) + (is_contradicted ? " The survey contradicts it there." : ""),
        .advice =
            "Check whether a cable or a load is missing there, or a node is drawn in a wrong "
            "place."};
    for (const int node : found->nodes) {
        finding.ids.push_back(net.node_id(node));
    }
    return finding;
}

}  // namespace taut
