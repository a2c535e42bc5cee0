// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/cable_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

#include "net/sliding_nodes.hpp"
#include "net/union_find.hpp"

namespace taut {
namespace {

/// Pairs of edges that continue each other straight through a node.
std::vector<std::pair<int, int>> straight_pairs(const CableNet& net, int node) {
    const std::span<const int> edges = net.edges_at(node);
    constexpr double straight = 0.866;  // cosine of 30 degrees
    constexpr size_t most_edges = 64;   // cables end at a hub, they do not pass through it
    if (edges.size() > most_edges) {
        return {};
    }
    std::vector<std::tuple<double, int, int>> candidates;
    const auto direction = [&](int edge) {
        const auto [s, t] = net.edges()[edge];
        return (net.nodes().col(s == node ? t : s) - net.nodes().col(node)).normalized().eval();
    };
    for (size_t i = 0; i < edges.size(); ++i) {
        for (size_t j = i + 1; j < edges.size(); ++j) {
            if (net.is_strut(edges[i]) || net.is_strut(edges[j])) {
                continue;  // a strut is cut by itself
            }
            const double cosine = direction(edges[i]).dot(direction(edges[j]));
            if (cosine < -straight) {
                candidates.emplace_back(cosine, edges[i], edges[j]);
            }
        }
    }
    std::ranges::sort(candidates);
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> taken;
    for (const auto& [cosine, a, b] : candidates) {
        if (std::ranges::find(taken, a) == taken.end() &&
            std::ranges::find(taken, b) == taken.end()) {
            pairs.emplace_back(a, b);
            taken.insert(taken.end(), {a, b});
        }
    }
    return pairs;
}

}  // namespace

std::vector<SlidingNode> sliding_nodes_of(const std::vector<Edge>& edges, const CableRun& run) {
    std::vector<SlidingNode> result;
    for (size_t i = 0; i + 1 < run.edges.size(); ++i) {
        const Edge& after = edges[run.edges[i + 1]];
        for (const int node : edges[run.edges[i]]) {
            if (std::ranges::find(after, node) != after.end() &&
                std::ranges::find(run.slides_at, node) != run.slides_at.end()) {
                const bool has_ratio = result.size() < run.ratios.size();
                result.push_back(
                    {.node = node,
                     .before = run.edges[i],
                     .after = run.edges[i + 1],
                     .friction = run.friction.value_or(0.0),
                     .ratio = has_ratio ? run.ratios[result.size()] : 1.0,
                     .most_friction = run.friction.value_or(CableRun::likely_friction) +
                                      CableRun::uncertain_friction});
            }
        }
    }
    return result;
}

std::vector<std::vector<int>> sliding_stretches(const CableNet& net) {
    std::vector<std::vector<int>> result;
    for (const SlidingNode& at : net.sliding_nodes()) {
        if (result.empty() || result.back().back() != at.before) {
            result.push_back({at.before});
        }
        result.back().push_back(at.after);
    }
    return result;
}

std::vector<int> stretch_of(const CableNet& net, int edge) {
    for (std::vector<int>& edges : sliding_stretches(net)) {
        if (std::ranges::find(edges, edge) != edges.end()) {
            return std::move(edges);
        }
    }
    return {edge};
}

std::vector<bool> edges_that_slide(const CableNet& net) {
    std::vector<bool> result(static_cast<size_t>(net.edge_count()), false);
    for (const SlidingNode& at : net.sliding_nodes()) {
        result[at.before] = result[at.after] = true;
    }
    return result;
}

CableNet clamped(const CableNet& net) {
    if (net.sliding_nodes().empty()) {
        return net;
    }
    CableNetData data = net.data();
    for (CableRun& run : data.runs) {
        run.slides_at.clear();
        run.ratios.clear();
    }
    return CableNet(std::move(data));
}

void refuse_sliding(const CableNet& net, std::string_view what) {
    const std::vector<CableRun>& runs = net.data().runs;
    for (int k = 0; k < std::ssize(runs); ++k) {
        if (!runs[k].slides_at.empty()) {
            throw NetError(
                "runs", {k},
                fmt::format("slides at its nodes, and {} takes every edge as clamped. "
                            "Leave out slides_at for that, or identify the net by the method map",
                            what));
        }
    }
}

std::vector<std::vector<int>> cable_runs(const CableNet& net) {
    std::vector<std::vector<int>> runs;
    if (!net.data().runs.empty()) {
        std::ranges::transform(net.data().runs, std::back_inserter(runs), &CableRun::edges);
        return runs;
    }
    UnionFind joined(net.edge_count());
    for (const int node : net.free_nodes()) {
        for (const auto& [a, b] : straight_pairs(net, node)) {
            joined.join(a, b);
        }
    }
    runs.resize(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        runs[joined.root(e)].push_back(e);
    }
    std::erase_if(runs, [](const std::vector<int>& run) { return run.size() < 2; });
    std::ranges::sort(runs);
    return runs;
}

}  // namespace taut
