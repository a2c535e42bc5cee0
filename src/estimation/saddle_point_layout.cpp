// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_layout.hpp"

#include <algorithm>
#include <numeric>

namespace taut {

SaddlePointLayout::SaddlePointLayout(const LocalNet& net, const std::vector<bool>& unknown,
                                     Supports supports, Lengths with_lengths)
    : lengths(with_lengths),
      free_count(net.free_count),
      support_blocks(supports == Supports::unknown ? static_cast<int>(net.supports.cols()) : 0),
      edges(net.edges),
      edges_of_node(node_count()),
      sizes(node_count(), 3),
      place(node_count()),
      length(net.edges.size(), -1) {
    // A block holds the lengths of edges to earlier blocks, and to nodes without one.
    const auto owner = [this](int edge) {
        const auto [s, t] = edges[edge];
        return !has_block(s) || is_before(s, t) ? block(t) : block(s);
    };
    for (int node = 0; node < free_count; ++node) {
        sizes[block(node)] += 3;
    }
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        for (const int node : edges[e]) {
            if (has_block(node)) {
                edges_of_node[node].push_back(e);
            }
        }
        if (unknown[e]) {
            length[e] = sizes[owner(e)]++;
        }
    }
    std::vector<int> first(sizes.size());
    std::exclusive_scan(sizes.begin(), sizes.end(), first.begin(), 0);
    for (int node = 0; node < node_count(); ++node) {
        place[node] = first[block(node)];
    }
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        if (is_unknown(e)) {
            length[e] += first[owner(e)];
        }
    }
}

std::vector<std::vector<int>> SaddlePointLayout::couplings() const {
    std::vector<std::vector<int>> result(sizes.size());
    for (int j = 0; j < node_count(); ++j) {
        std::vector<int>& coupled = result[block(j)];
        for (const int e : edges_of_node[j]) {
            const int other = other_end(e, j);
            if (is_before(j, other)) {  // so it is free
                for (int k = 0; k < 6; ++k) {
                    coupled.push_back(place[other] + k);
                }
                if (is_unknown(e)) {
                    coupled.push_back(length[e]);
                }
            }
        }
    }
    if (lengths == Lengths::coupled) {
        couple_lengths(result);
    }
    return result;
}

/// Each with all of later blocks.
void SaddlePointLayout::couple_lengths(std::vector<std::vector<int>>& couplings) const {
    std::vector<int> unknown = length;
    std::erase(unknown, -1);
    std::ranges::sort(unknown);
    int first = 0;
    auto own = unknown.begin();
    for (size_t block = 0; block < couplings.size(); ++block) {
        first += sizes[block];
        const auto later = std::lower_bound(own, unknown.end(), first);
        if (later != own) {
            couplings[block].insert(couplings[block].end(), later, unknown.end());
        }
        own = later;
    }
}

}  // namespace taut
