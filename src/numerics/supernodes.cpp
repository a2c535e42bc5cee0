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

/// The share of stored zeros tolerated in this number of columns: small products gain much by being
/// larger.
double tolerated_zeros(int columns) {
    return columns <= 32 ? 0.3 : columns <= 96 ? 0.15 : 0.05;
}

/// A supernode before its rows are known.
struct Node {
    Supernode supernode;
    std::int64_t row_count = 0;  ///< unknowns
    std::int64_t nonzeros = 0;   ///< in its columns of the factor's lower triangle

    /// Number of stored entries.
    [[nodiscard]] std::int64_t entries() const {
        const auto p = static_cast<std::int64_t>(supernode.size);
        return p * (p + 1) / 2 + p * row_count;
    }
};

/// For each block the earlier blocks that it has entries with, one list after the other.
struct Earlier {
    std::vector<int> blocks;
    std::vector<size_t> starts;
};

Earlier earlier_of(const std::vector<std::vector<int>>& couplings) {
    Earlier result{.blocks = {}, .starts = std::vector<size_t>(couplings.size() + 1, 0)};
    for (const std::vector<int>& later : couplings) {
        for (const int block : later) {
            ++result.starts[block + 1];
        }
    }
    std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
    result.blocks.resize(result.starts.back());
    std::vector<size_t> next(result.starts.begin(), result.starts.end() - 1);
    for (int j = 0; j < static_cast<int>(couplings.size()); ++j) {
        for (const int block : couplings[j]) {
            result.blocks[next[block]++] = j;
        }
    }
    return result;
}

/// Supernodes of one block each: row by row, each is the path from the row's entries of A to itself
/// (T. A. Davis, Direct Methods for Sparse Linear Systems, SIAM 2006, sections 4.1 and 4.4).
std::vector<Node> elimination_tree(const std::vector<int>& sizes,
                                   const std::vector<std::vector<int>>& couplings) {
    const Earlier earlier = earlier_of(couplings);
    std::vector<Node> nodes(sizes.size());
    std::vector<int> visited(sizes.size(), -1);  // last row that came to each block
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
        visited[j] = j;
        nodes[j].supernode.blocks = {j};
        nodes[j].supernode.size = sizes[j];
        for (size_t k = earlier.starts[j]; k < earlier.starts[j + 1]; ++k) {
            for (int i = earlier.blocks[k]; visited[i] != j; i = nodes[i].supernode.parent) {
                visited[i] = j;
                nodes[i].row_count += sizes[j];
                if (nodes[i].supernode.parent < 0) {
                    nodes[i].supernode.parent = j;
                    nodes[j].supernode.children.push_back(i);
                }
            }
        }
    }
    return nodes;
}

/// Merges children into their parents. Merged children keep no blocks.
void amalgamate(std::vector<Node>& nodes) {
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
        Node& node = nodes[j];
        node.nonzeros = node.entries();
        Supernode& parent = node.supernode;
        // Children with the most rows add the fewest zeros.
        std::vector<int> candidates = std::exchange(parent.children, {});
        std::ranges::sort(candidates, std::greater{},
                          [&](int child) { return std::pair(nodes[child].row_count, child); });
        for (const int c : candidates) {
            Supernode& child = nodes[c].supernode;
            parent.size += child.size;
            const std::int64_t both = node.nonzeros + nodes[c].nonzeros;
            const double zeros =
                1.0 - static_cast<double>(both) / static_cast<double>(node.entries());
            if (zeros > tolerated_zeros(parent.size)) {
                parent.size -= child.size;
                parent.children.push_back(c);
                continue;
            }
            node.nonzeros = both;
            parent.blocks.insert(parent.blocks.end(), child.blocks.begin(), child.blocks.end());
            parent.children.insert(parent.children.end(), child.children.begin(),
                                   child.children.end());
            child = {};
        }
        std::ranges::sort(parent.blocks);
        for (const int child : parent.children) {
            nodes[child].supernode.parent = j;
        }
    }
}

/// Sorts the children of each node by the peak memory of their subtrees less the update that is
/// left, largest first: this keeps the memory of waiting updates small (Liu 1986).
void sort_children(std::vector<Node>& nodes) {
    std::vector<std::int64_t> most(nodes.size(), 0);
    std::vector<std::int64_t> update(nodes.size(), 0);
    for (size_t j = 0; j < nodes.size(); ++j) {
        update[j] = nodes[j].row_count * nodes[j].row_count;
        std::vector<int>& children = nodes[j].supernode.children;
        std::ranges::sort(children, std::greater{},
                          [&](int child) { return std::pair(most[child] - update[child], child); });
        std::int64_t waiting = 0;
        for (const int child : children) {
            most[j] = std::max(most[j], waiting + most[child]);
            waiting += update[child];
        }
        most[j] = std::max(most[j], waiting + update[j]);
    }
}

/// The remaining supernodes, children before parents.
std::vector<int> depth_first(const std::vector<Node>& nodes) {
    std::vector<int> stack;
    for (int j = static_cast<int>(nodes.size()) - 1; j >= 0; --j) {
        const Supernode& node = nodes[j].supernode;
        if (node.parent < 0 && !node.blocks.empty()) {
            stack.push_back(j);
        }
    }
    std::vector<int> sequence;
    while (!stack.empty()) {
        const int j = stack.back();
        stack.pop_back();
        sequence.push_back(j);
        const std::vector<int>& children = nodes[j].supernode.children;
        stack.insert(stack.end(), children.begin(), children.end());
    }
    std::ranges::reverse(sequence);
    return sequence;
}

/// Numbers the pivots in the order of the supernodes.
/// @return the first number of each block
std::vector<int> number_pivots(const std::vector<int>& sizes, SupernodeTree& tree) {
    std::vector<int> first_of(sizes.size());
    std::exclusive_scan(sizes.begin(), sizes.end(), first_of.begin(), 0);
    tree.number.resize(std::accumulate(sizes.begin(), sizes.end(), size_t{0}));
    std::vector<int> begins(sizes.size());
    int next = 0;
    for (Supernode& node : tree.supernodes) {
        node.begin = next;
        for (const int block : node.blocks) {
            begins[block] = next;
            for (int k = 0; k < sizes[block]; ++k) {
                tree.number[first_of[block] + k] = next++;
            }
        }
    }
    return begins;
}

/// Fills in the rows: those of a supernode's blocks and of its children, less its own pivots.
void find_rows(const std::vector<int>& sizes, const std::vector<std::vector<int>>& couplings,
               SupernodeTree& tree) {
    const std::vector<int> begins = number_pivots(sizes, tree);
    std::vector<std::vector<int>> row_blocks(tree.supernodes.size());
    std::vector<int> found(sizes.size(), -1);  // last supernode that has each block
    for (int j = 0; j < static_cast<int>(tree.supernodes.size()); ++j) {
        Supernode& node = tree.supernodes[j];
        for (const int block : node.blocks) {
            found[block] = j;
        }
        const auto take = [&](const std::vector<int>& blocks) {
            for (const int block : blocks) {
                if (found[block] != j) {
                    found[block] = j;
                    row_blocks[j].push_back(block);
                }
            }
        };
        for (const int block : node.blocks) {
            take(couplings[block]);
        }
        for (const int child : node.children) {
            take(std::exchange(row_blocks[child], {}));
        }
        std::ranges::sort(row_blocks[j], {}, [&](int block) { return begins[block]; });
        for (const int block : row_blocks[j]) {
            for (int k = 0; k < sizes[block]; ++k) {
                node.rows.push_back(begins[block] + k);
            }
        }
    }
}

}  // namespace

int Supernode::place_of(int unknown) const {
    return unknown < begin + size
               ? unknown - begin
               : size + static_cast<int>(std::ranges::lower_bound(rows, unknown) - rows.begin());
}

SupernodeTree supernode_tree(const std::vector<int>& sizes,
                             const std::vector<std::vector<int>>& couplings) {
    std::vector<Node> nodes = elimination_tree(sizes, couplings);
    amalgamate(nodes);
    sort_children(nodes);
    const std::vector<int> sequence = depth_first(nodes);

    std::vector<int> place(sizes.size(), -1);  // of the supernodes in the sequence
    SupernodeTree tree;
    tree.supernodes.reserve(sequence.size());
    for (const int j : sequence) {
        place[j] = static_cast<int>(tree.supernodes.size());
        tree.supernodes.push_back(std::move(nodes[j].supernode));
    }
    for (Supernode& node : tree.supernodes) {
        for (int& child : node.children) {
            child = place[child];
        }
        node.parent = node.parent < 0 ? -1 : place[node.parent];
    }
    find_rows(sizes, couplings, tree);
    for (Supernode& node : tree.supernodes) {
        node.rows_in_parent.reserve(node.rows.size());
        for (const int row : node.rows) {
            node.rows_in_parent.push_back(tree.supernodes[node.parent].place_of(row));
        }
    }
    return tree;
}

}  // namespace taut
