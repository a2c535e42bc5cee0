// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_layout.hpp"

#include <algorithm>
#include <numeric>

namespace taut {

SaddlePointLayout::SaddlePointLayout(const LocalNet& net, const std::vector<bool>& interior)
    : edges(net.edges),
      edges_of_node(net.free_count),
      sizes(net.free_count, 6),
      place(net.free_count),
      length(net.edges.size(), -1) {
    // The later one of an edge's free nodes.
    const auto owner = [&](int edge) {
        const auto [first, last] = std::minmax(edges[edge][0], edges[edge][1]);
        return last < net.free_count ? last : first;
    };
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        for (const int node : edges[e]) {
            if (node < net.free_count) {
                edges_of_node[node].push_back(e);
            }
        }
        if (interior[e]) {
            length[e] = sizes[owner(e)]++;
        }
    }
    std::exclusive_scan(sizes.begin(), sizes.end(), place.begin(), 0);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        if (is_unknown(e)) {
            length[e] += place[owner(e)];
        }
    }
}

std::vector<std::vector<int>> SaddlePointLayout::couplings() const {
    std::vector<std::vector<int>> result(sizes.size());
    for (int j = 0; j < free_count(); ++j) {
        for (const int e : edges_of_node[j]) {
            const int other = other_end(e, j);
            if (other > j && other < free_count()) {
                for (int k = 0; k < 6; ++k) {
                    result[j].push_back(place[other] + k);
                }
                if (is_unknown(e)) {
                    result[j].push_back(length[e]);
                }
            }
        }
    }
    return result;
}

}  // namespace taut
