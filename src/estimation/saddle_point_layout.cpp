// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/saddle_point_layout.hpp"

#include <numeric>
#include <utility>

namespace taut {

SaddlePointLayout::SaddlePointLayout(const LocalNet& net, const std::vector<bool>& unknown_lengths,
                                     Supports supports, Lengths with_lengths, LengthsGo go)
    : lengths(with_lengths),
      lengths_go(go),
      free_count(net.free_count),
      support_blocks(supports == Supports::uncertain ? static_cast<int>(net.supports.cols()) : 0),
      edges(net.edges),
      unknown(unknown_lengths),
      edges_of_node(node_count()),
      pairs_of_node(node_count()),
      place(node_count()),
      length(net.edges.size(), -1) {
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        for (const int node : edges[e]) {
            if (has_block(node)) {
                edges_of_node[node].push_back(e);
            }
        }
    }
    for (int k = 0; k < static_cast<int>(net.spring_pairs.size()); ++k) {
        const SpringPair& pair = net.spring_pairs[static_cast<size_t>(k)];
        pairs_of_node[pair.first].push_back(
            {.index = k, .other = pair.second, .is_joined = pair.edge >= 0});
    }
    int next = 0;
    const auto number = [&next](int count) { return std::exchange(next, next + count); };
    for (int support = 0; support < support_blocks; ++support) {
        place[free_count + support] = number(3);
        add_block(3, free_count + support, -1);
    }
    for (int node = 0; node < free_count; ++node) {
        place[node] = number(6);
        add_block(6, node, -1);
        for (const int e : edges_of_node[node]) {
            if (go == LengthsGo::last && unknown[e] && !is_before(node, other_end(e, node))) {
                length[e] = number(1);
                add_block(1, -1, e);
            }
        }
    }
}

void SaddlePointLayout::add_block(int size, int node, int edge) {
    sizes.push_back(size);
    node_of_block.push_back(node);
    edge_of_block.push_back(edge);
}

int SaddlePointLayout::parameter_count() const {
    return std::accumulate(sizes.begin(), sizes.end(), 0);
}

std::vector<std::vector<int>> SaddlePointLayout::couplings() const {
    std::vector<int> block_of_node(node_count());
    std::vector<int> block_of_length(edges.size());
    for (int block = 0; block < static_cast<int>(sizes.size()); ++block) {
        if (const int node = node_of_block[block]; node >= 0) {
            block_of_node[node] = block;
        } else {
            block_of_length[edge_of_block[block]] = block;
        }
    }
    std::vector<std::vector<int>> result(sizes.size());
    for (int node = 0; node < node_count(); ++node) {
        std::vector<int>& coupled = result[block_of_node[node]];
        for (const Pair& pair : pairs_of_node[node]) {
            if (!pair.is_joined) {
                coupled.push_back(block_of_node[pair.other]);
            }
        }
        for (const int e : edges_of_node[node]) {
            const int other = other_end(e, node);
            if (is_before(node, other)) {  // so it is free
                coupled.push_back(block_of_node[other]);
            }
            if (has_length(e)) {
                coupled.push_back(block_of_length[e]);
            }
        }
    }
    if (lengths == Lengths::coupled) {
        couple_lengths(result);
    }
    return result;
}

/// Each with all later ones.
void SaddlePointLayout::couple_lengths(std::vector<std::vector<int>>& couplings) const {
    std::vector<int> later;
    for (int block = static_cast<int>(sizes.size()); block-- > 0;) {
        if (edge_of_block[block] >= 0) {
            couplings[block] = later;
            later.push_back(block);
        }
    }
}

}  // namespace taut
