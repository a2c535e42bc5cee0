// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/supernodes.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

namespace taut {
namespace {

/// Entries of the factor's lower triangle in the columns of a supernode.
std::int64_t entries_of(const Supernode& node) {
    const auto p = static_cast<std::int64_t>(node.size);
    return p * (p + 1) / 2 + p * static_cast<std::int64_t>(node.rows.size());
}

/// How many of so many columns' entries may be zeros: small products gain much by being larger.
double tolerated_zeros(int columns) {
    return columns <= 32 ? 0.5 : columns <= 96 ? 0.15 : 0.05;
}

/// Fills rows, parents and children of supernodes of one block each.
std::vector<Supernode> elimination_tree(const std::vector<int>& sizes,
                                        std::vector<std::vector<int>>& couplings) {
    std::vector<Supernode> nodes(sizes.size());
    std::vector<int> block_of;
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
        Supernode& node = nodes[j];
        node.blocks = {j};
        node.begin = static_cast<int>(block_of.size());
        node.size = sizes[j];
        block_of.resize(block_of.size() + static_cast<size_t>(node.size), j);
    }
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
        Supernode& node = nodes[j];
        node.rows = std::move(couplings[j]);
        for (const int child : node.children) {
            std::ranges::copy_if(nodes[child].rows, std::back_inserter(node.rows),
                                 [&](int row) { return row >= node.begin + node.size; });
        }
        std::ranges::sort(node.rows);
        // Not std::ranges::unique, which Clang 14 cannot take from GCC's library.
        node.rows.erase(
            std::unique(node.rows.begin(), node.rows.end()),  // NOLINT(modernize-use-ranges)
            node.rows.end());
        if (!node.rows.empty()) {
            node.parent = block_of[node.rows.front()];
            nodes[node.parent].children.push_back(j);
        }
    }
    return nodes;
}

/// Merges children into their parents; those that are merged keep no blocks.
void amalgamate(std::vector<Supernode>& nodes) {
    std::vector<std::int64_t> nonzeros(nodes.size());
    std::ranges::transform(nodes, nonzeros.begin(), entries_of);
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
        Supernode& node = nodes[j];
        // Those with the most rows add the fewest zeros.
        std::vector<int> candidates = std::exchange(node.children, {});
        std::ranges::sort(candidates, std::greater{},
                          [&](int child) { return std::pair(nodes[child].rows.size(), child); });
        for (const int c : candidates) {
            Supernode& child = nodes[c];
            node.size += child.size;
            const std::int64_t both = nonzeros[j] + nonzeros[c];
            const double zeros =
                1.0 - static_cast<double>(both) / static_cast<double>(entries_of(node));
            if (zeros > tolerated_zeros(node.size)) {
                node.size -= child.size;
                node.children.push_back(c);
                continue;
            }
            nonzeros[j] = both;
            node.blocks.insert(node.blocks.end(), child.blocks.begin(), child.blocks.end());
            node.children.insert(node.children.end(), child.children.begin(), child.children.end());
            child = {};
        }
        std::ranges::sort(node.blocks);
        for (const int child : node.children) {
            nodes[child].parent = j;
        }
    }
}

/// The supernodes that are left, children before parents.
std::vector<int> depth_first(const std::vector<Supernode>& nodes) {
    std::vector<int> stack;
    for (int j = static_cast<int>(nodes.size()) - 1; j >= 0; --j) {
        if (nodes[j].parent < 0 && !nodes[j].blocks.empty()) {
            stack.push_back(j);
        }
    }
    std::vector<int> sequence;
    while (!stack.empty()) {
        const int j = stack.back();
        stack.pop_back();
        sequence.push_back(j);
        stack.insert(stack.end(), nodes[j].children.begin(), nodes[j].children.end());
    }
    std::ranges::reverse(sequence);
    return sequence;
}

}  // namespace

int Supernode::place_of(int unknown) const {
    return unknown < begin + size
               ? unknown - begin
               : size + static_cast<int>(std::ranges::lower_bound(rows, unknown) - rows.begin());
}

SupernodeTree supernode_tree(const std::vector<int>& sizes,
                             std::vector<std::vector<int>> couplings) {
    std::vector<Supernode> nodes = elimination_tree(sizes, couplings);
    amalgamate(nodes);
    const std::vector<int> sequence = depth_first(nodes);

    std::vector<int> first_of(sizes.size());
    std::exclusive_scan(sizes.begin(), sizes.end(), first_of.begin(), 0);
    std::vector<int> place(sizes.size(), -1);  // of the supernodes in the sequence
    SupernodeTree tree{.supernodes = {},
                       .number = std::vector<int>(std::accumulate(sizes.begin(), sizes.end(), 0))};
    int next = 0;
    for (const int j : sequence) {
        place[j] = static_cast<int>(tree.supernodes.size());
        Supernode& node = tree.supernodes.emplace_back(std::move(nodes[j]));
        node.begin = next;
        for (const int block : node.blocks) {
            for (int k = 0; k < sizes[block]; ++k) {
                tree.number[first_of[block] + k] = next++;
            }
        }
    }
    for (Supernode& node : tree.supernodes) {
        for (int& child : node.children) {
            child = place[child];
        }
        node.parent = node.parent < 0 ? -1 : place[node.parent];
        for (int& row : node.rows) {
            row = tree.number[row];
        }
        std::ranges::sort(node.rows);
    }
    for (Supernode& node : tree.supernodes) {
        for (const int row : node.rows) {
            node.rows_in_parent.push_back(tree.supernodes[node.parent].place_of(row));
        }
    }
    return tree;
}

}  // namespace taut
