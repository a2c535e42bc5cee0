// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace taut {

/// Blocks of unknowns that are eliminated together, as one dense matrix.
struct Supernode {
    std::vector<int> blocks;  ///< ascending
    int begin = 0;            ///< the pivots are the unknowns begin .. begin + size
    int size = 0;
    std::vector<int> rows;  ///< later unknowns that the pivots are coupled with, ascending
    int parent = -1;
    std::vector<int> children;
    /// Where each of the rows stands in the parent's dense matrix: its pivots, then its rows.
    std::vector<int> rows_in_parent;

    /// Where an unknown stands in the dense matrix: one of the pivots or of the rows.
    [[nodiscard]] int place_of(int unknown) const;
};

struct SupernodeTree {
    /// Children before their parents, depth first, and of several children first those whose
    /// subtrees need the most memory beyond what they leave (J. W. H. Liu, On the storage
    /// requirement in the out-of-core multifrontal method for sparse factorization, ACM TOMS 12
    /// (1986) 249-264): few updates wait at any time.
    std::vector<Supernode> supernodes;
    /// Number of each unknown in the order of the supernodes' pivots.
    std::vector<int> number;
};

/// The elimination tree of a symmetric matrix whose unknowns come in blocks, eliminated block by
/// block; children are merged into their parents where this stores few zeros for the larger dense
/// products (relaxed amalgamation: Ashcraft & Grimes, The influence of relaxed supernode partitions
/// on the multifrontal method, ACM TOMS 15, 1989). Blocks keep their order along each branch.
///
/// @param sizes of the blocks; unknowns are given as if numbered block by block
/// @param couplings one list a block: later blocks that it has entries with, each named once
[[nodiscard]] SupernodeTree supernode_tree(const std::vector<int>& sizes,
                                           const std::vector<std::vector<int>>& couplings);

}  // namespace taut
