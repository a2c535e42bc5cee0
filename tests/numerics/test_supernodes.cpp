// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against supernodes that miss fill, break the order along a branch, or store many zeros.

#include "numerics/supernodes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <numeric>

namespace {

using namespace taut;

/// A grid of blocks of two and three unknowns by turns, coupled with the next in both directions.
class OnAGrid : public testing::Test {
protected:
    static constexpr int side = 12;

    OnAGrid() {
        for (int j = 0; j < side * side; ++j) {
            m_first.push_back(m_count);
            m_sizes.push_back(2 + j % 2);
            m_count += m_sizes.back();
        }
        for (int j = 0; j < side * side; ++j) {
            std::vector<int>& coupled = m_couplings.emplace_back();
            for (const int other : {j % side + 1 < side ? j + 1 : side * side, j + side}) {
                if (other < side * side) {
                    coupled.push_back(other);
                }
            }
        }
    }

    /// Where the factor of the dense matrix, in the order of the tree, has entries.
    [[nodiscard]] Eigen::MatrixXi filled(const SupernodeTree& tree) const {
        Eigen::MatrixXi pattern = Eigen::MatrixXi::Zero(m_count, m_count);
        const auto set = [&](int a, int b) {
            const int i = tree.number[size_t(a)];
            const int j = tree.number[size_t(b)];
            pattern(std::max(i, j), std::min(i, j)) = 1;
        };
        for (size_t j = 0; j < m_sizes.size(); ++j) {
            for (int a = m_first[j]; a < m_first[j] + m_sizes[j]; ++a) {
                for (int b = m_first[j]; b <= a; ++b) {
                    set(a, b);
                }
                for (const int later : m_couplings[j]) {
                    for (int k = 0; k < m_sizes[size_t(later)]; ++k) {
                        set(a, m_first[size_t(later)] + k);
                    }
                }
            }
        }
        for (int k = 0; k < m_count; ++k) {
            for (int j = k + 1; j < m_count; ++j) {
                for (int i = j; pattern(j, k) != 0 && i < m_count; ++i) {
                    pattern(i, j) |= pattern(i, k);
                }
            }
        }
        return pattern;
    }

    std::vector<int> m_sizes;
    std::vector<int> m_first;
    std::vector<std::vector<int>> m_couplings;
    int m_count = 0;
};

TEST_F(OnAGrid, TheSupernodesHoldAllFillAndFewZeros) {
    const SupernodeTree tree = supernode_tree(m_sizes, m_couplings);
    EXPECT_LT(tree.supernodes.size(), m_sizes.size() / 3);

    std::vector<int> sorted = tree.number;
    std::ranges::sort(sorted);
    std::vector<int> all(m_count);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);

    const Eigen::MatrixXi pattern = filled(tree);
    Eigen::MatrixXi stored = Eigen::MatrixXi::Zero(m_count, m_count);
    for (const Supernode& node : tree.supernodes) {
        for (int k = 0; k < node.size; ++k) {
            stored.col(node.begin + k).segment(node.begin + k, node.size - k).setOnes();
            for (const int row : node.rows) {
                stored(row, node.begin + k) = 1;
            }
        }
    }
    EXPECT_EQ((pattern.array() > stored.array()).count(), 0);
    EXPECT_LT(stored.sum(), 1.5 * pattern.sum());
}

TEST_F(OnAGrid, ChildrenComeBeforeTheirParentsDepthFirst) {
    const SupernodeTree tree = supernode_tree(m_sizes, m_couplings);
    std::vector<int> first;  // supernode of the subtree
    for (int j = 0; j < static_cast<int>(tree.supernodes.size()); ++j) {
        const Supernode& node = tree.supernodes[size_t(j)];
        int subtree = 1;
        first.push_back(j);
        for (const int child : node.children) {
            ASSERT_LT(child, j);
            EXPECT_EQ(tree.supernodes[size_t(child)].parent, j);
            subtree += child - first[size_t(child)] + 1;
            first.back() = std::min(first.back(), first[size_t(child)]);
        }
        EXPECT_EQ(subtree, j - first.back() + 1);
        EXPECT_TRUE(std::ranges::is_sorted(node.blocks));
        for (size_t k = 0; k < node.rows.size(); ++k) {
            const Supernode& parent = tree.supernodes[size_t(node.parent)];
            const int place = node.rows_in_parent[k];
            EXPECT_EQ(node.rows[k], place < parent.size ? parent.begin + place
                                                        : parent.rows[size_t(place - parent.size)]);
        }
    }
}

TEST(SupernodeTree, SeparatePartsHaveTheirOwnRoots) {
    const SupernodeTree tree = supernode_tree({2, 3, 1}, {{}, {2}, {}});
    ASSERT_EQ(tree.supernodes.size(), 2U);
    EXPECT_EQ(tree.supernodes[0].size + tree.supernodes[1].size, 6);
    EXPECT_EQ(tree.supernodes[0].parent, -1);
    EXPECT_EQ(tree.supernodes[1].parent, -1);
}

}  // namespace
