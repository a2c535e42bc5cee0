// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "statics/local_net.hpp"

namespace taut {

/// How the unknowns of the saddle-point matrix of a net are numbered: a block a free node, in the
/// order of the local net, of its place, its multipliers, and the unknown lengths of its edges to
/// earlier nodes and to supports.
struct SaddlePointLayout {
    /// @param interior one flag an edge of the net: whether its length is unknown
    SaddlePointLayout(const LocalNet& net, const std::vector<bool>& interior);

    std::vector<Edge> edges;                      ///< of the local net
    std::vector<std::vector<int>> edges_of_node;  ///< of each free node
    std::vector<int> sizes;                       ///< of the blocks
    std::vector<int> place;                       ///< of each free node: the first of three
    std::vector<int> length;                      ///< of each edge; -1 for a known length

    [[nodiscard]] int free_count() const { return static_cast<int>(place.size()); }
    [[nodiscard]] int multiplier(int node) const { return place[node] + 3; }
    [[nodiscard]] bool is_unknown(int edge) const { return length[edge] >= 0; }
    [[nodiscard]] int other_end(int edge, int node) const {
        return edges[edge][0] + edges[edge][1] - node;
    }
    /// Of each block, the unknowns of later blocks that it has entries with.
    [[nodiscard]] std::vector<std::vector<int>> couplings() const;
};

}  // namespace taut
