// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/cable_runs.hpp"

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
                result.push_back({.node = node,
                                  .before = run.edges[i],
                                  .after = run.edges[i + 1],
                                  .friction = run.friction});
            }
        }
    }
    return result;
}

void refuse_sliding(const CableNet& net) {
    const std::vector<CableRun>& runs = net.data().runs;
    for (int k = 0; k < std::ssize(runs); ++k) {
        if (!runs[k].slides_at.empty()) {
            throw NetError("runs", {k},
                           "slides at its nodes: lengths of such a net are not identified yet, nor "
                           "is a model trained. Without slides_at its edges are taken as clamped");
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
