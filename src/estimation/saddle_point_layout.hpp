// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "statics/local_net.hpp"

namespace taut {

/// Whether the places of the supports are given, or unknown like those of the free nodes.
enum class Supports { fixed, unknown };

/// Whether the weights of the lengths are one an edge, or a full matrix.
enum class Lengths { independent, coupled };

/// How the unknowns of the saddle-point matrix of a net are numbered: first a block a support, of
/// its place, where these are unknown; then a block a free node, in the order of the local net, of
/// its place, its multipliers, and the unknown lengths of its edges to earlier nodes and to
/// supports.
struct SaddlePointLayout {
    /// @param unknown one flag an edge of the net: whether its length is unknown
    SaddlePointLayout(const LocalNet& net, const std::vector<bool>& unknown,
                      Supports supports = Supports::fixed, Lengths lengths = Lengths::independent);

    Lengths lengths = Lengths::independent;
    int free_count = 0;
    int support_blocks = 0;                       ///< 0 where supports are fixed
    std::vector<Edge> edges;                      ///< of the local net
    std::vector<std::vector<int>> edges_of_node;  ///< of each node with a block
    std::vector<int> sizes;                       ///< of the blocks
    std::vector<int> place;                       ///< of each node with a block: the first of three
    std::vector<int> length;                      ///< of each edge; -1 for a known length

    /// Free nodes, and supports where these are unknown: those that have a block.
    [[nodiscard]] int node_count() const { return free_count + support_blocks; }
    [[nodiscard]] bool is_free(int node) const { return node < free_count; }
    [[nodiscard]] bool has_block(int node) const { return node < node_count(); }
    [[nodiscard]] int block(int node) const {
        return is_free(node) ? support_blocks + node : node - free_count;
    }
    [[nodiscard]] int node_of(int block) const {
        return block < support_blocks ? free_count + block : block - support_blocks;
    }
    [[nodiscard]] int multiplier(int node) const { return place[node] + 3; }
    [[nodiscard]] bool is_unknown(int edge) const { return length[edge] >= 0; }
    [[nodiscard]] int other_end(int edge, int node) const {
        return edges[edge][0] + edges[edge][1] - node;
    }
    /// Whether a node's block is eliminated before that of the other end of one of its edges.
    [[nodiscard]] bool is_before(int node, int other) const {
        return has_block(other) && block(node) < block(other);
    }
    /// Of each block, the unknowns of later blocks that it has entries with.
    [[nodiscard]] std::vector<std::vector<int>> couplings() const;

private:
    void couple_lengths(std::vector<std::vector<int>>& couplings) const;
};

}  // namespace taut
