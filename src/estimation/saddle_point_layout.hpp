// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "statics/local_net.hpp"

namespace taut {

/// Whether the places of the supports are known, or unknowns like those of the free nodes.
enum class Supports { fixed, uncertain };

/// Whether the weights of the lengths are one an edge, or a full matrix.
enum class Lengths { independent, coupled };

/// Whether a length is eliminated after both its ends, or before all of these: then it takes no
/// part in the matrix, to which its edge adds what eliminating it leaves.
enum class LengthsGo { last, first };

/// How the unknowns of the saddle-point matrix of a net are numbered: first one block a support, of
/// its place, where supports are uncertain; then one block a free node, in the order of the local
/// net, of its place and its multipliers; and after it, where lengths go last, one block a length
/// of its edges to earlier nodes and to supports.
struct SaddlePointLayout {
    /// @param unknown one flag an edge of the net: whether its length is an unknown
    SaddlePointLayout(const LocalNet& net, const std::vector<bool>& unknown,
                      Supports supports = Supports::fixed, Lengths lengths = Lengths::independent,
                      LengthsGo lengths_go = LengthsGo::last);

    Lengths lengths = Lengths::independent;
    LengthsGo lengths_go = LengthsGo::last;
    int free_count = 0;
    int support_blocks = 0;                       ///< 0 where supports are fixed
    std::vector<Edge> edges;                      ///< of the local net
    std::vector<bool> unknown;                    ///< whether an edge's length is
    std::vector<std::vector<int>> edges_of_node;  ///< of each node with a block
    /// A pair of elastic supports on one frame, at the one that is eliminated first.
    struct Pair {
        int index;       ///< in LocalNet::spring_pairs
        int other;       ///< node
        bool is_joined;  ///< whether an edge joins them, too
    };
    std::vector<std::vector<Pair>> pairs_of_node;
    std::vector<int> sizes;          ///< of the blocks
    std::vector<int> node_of_block;  ///< -1 where it is a length
    std::vector<int> edge_of_block;  ///< -1 where it is a node
    std::vector<int> place;          ///< of each node with a block: the first of three unknowns
    std::vector<int> length;         ///< of each edge; -1 where it is no unknown of the matrix

    /// Free nodes, and supports where these are uncertain: those that have a block.
    [[nodiscard]] int node_count() const { return free_count + support_blocks; }
    [[nodiscard]] bool is_free(int node) const { return node < free_count; }
    [[nodiscard]] bool has_block(int node) const { return node < node_count(); }
    [[nodiscard]] int multiplier(int node) const { return place[node] + 3; }
    /// Whether a length is an unknown of the matrix.
    [[nodiscard]] bool has_length(int edge) const { return length[edge] >= 0; }
    /// Whether a length is eliminated before the matrix.
    [[nodiscard]] bool goes_first(int edge) const {
        return lengths_go == LengthsGo::first && unknown[edge];
    }
    [[nodiscard]] int other_end(int edge, int node) const {
        return edges[edge][0] + edges[edge][1] - node;
    }
    /// Whether a node's block is eliminated before that of the other end of one of its edges.
    [[nodiscard]] bool is_before(int node, int other) const {
        return has_block(other) && rank(node) < rank(other);
    }
    [[nodiscard]] int parameter_count() const;
    /// Of each block, the later blocks that it has entries with.
    [[nodiscard]] std::vector<std::vector<int>> couplings() const;

private:
    /// Supports are eliminated first.
    [[nodiscard]] int rank(int node) const {
        return is_free(node) ? support_blocks + node : node - free_count;
    }
    void add_block(int size, int node, int edge);
    void couple_lengths(std::vector<std::vector<int>>& couplings) const;
};

}  // namespace taut
