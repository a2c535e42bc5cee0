// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against orders that miss a row, that depend on the state of rand(), or that fill the
// factor.
#include "numerics/elimination_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "numerics/nested_dissection.hpp"
#include "numerics/supernodal_factor.hpp"

namespace {

using namespace taut;

/// A square grid, each node joined with the next in both directions.
std::vector<std::array<int, 2>> grid(int side) {
    std::vector<std::array<int, 2>> pairs;
    for (int j = 0; j < side * side; ++j) {
        if (j % side + 1 < side) {
            pairs.push_back({j, j + 1});
        }
        if (j + side < side * side) {
            pairs.push_back({j + side, j});
        }
    }
    return pairs;
}

/// Operations of the factor of a grid in an order.
double work_of(int side, const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (size_t k = 0; k < order.size(); ++k) {
        place[order[k]] = static_cast<int>(k);
    }
    std::vector<std::vector<int>> couplings(order.size());
    for (const auto& [a, b] : grid(side)) {
        couplings[std::min(place[a], place[b])].push_back(std::max(place[a], place[b]));
    }
    return SupernodalFactor(std::vector<int>(order.size(), 1), couplings).operation_count();
}

bool is_permutation_of_rows(std::vector<int> order) {
    std::vector<int> all(order.size());
    std::iota(all.begin(), all.end(), 0);
    std::ranges::sort(order);
    return order == all;
}

TEST(MatrixGraph, HoldsEachPairAtBothRows) {
    const MatrixGraph graph = graph_of(4, {{2, 0}, {1, 2}});
    EXPECT_EQ(graph.starts, (std::vector{0, 1, 2, 4, 4}));
    EXPECT_EQ(graph.neighbours, (std::vector{2, 2, 0, 1}));
}

TEST(EliminationOrder, ListsEachRowOnce) {
    for (const int side : {1, 7, 80}) {
        const MatrixGraph graph = graph_of(side * side, grid(side));
        for (const Ordering ordering : {Ordering::quick, Ordering::thorough}) {
            const std::vector<int> order = elimination_order(graph, ordering);
            EXPECT_EQ(std::ssize(order), side * side);
            EXPECT_TRUE(is_permutation_of_rows(order));
        }
    }
}

TEST(EliminationOrder, LeavesLessWorkIfThorough) {
    constexpr int side = 150;
    const MatrixGraph graph = graph_of(side * side, grid(side));
    if (nested_dissection(graph).empty()) {
        GTEST_SKIP() << "built without METIS";
    }
    const double quick = work_of(side, elimination_order(graph, Ordering::quick));
    const double thorough = work_of(side, elimination_order(graph, Ordering::thorough));
    EXPECT_LT(thorough, 0.95 * quick);
    EXPECT_LT(quick, 20.0 * side * side * side);
}

TEST(EliminationOrder, NeitherDependsOnRandNorChangesIt) {
    const MatrixGraph graph = graph_of(6400, grid(80));
    srand(7);
    const int expected_draw = rand();
    srand(7);
    const std::vector<int> order = elimination_order(graph, Ordering::thorough);
    EXPECT_EQ(rand(), expected_draw);
    EXPECT_EQ(elimination_order(graph, Ordering::thorough), order);
}

}  // namespace
