// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against runs of cable that end where the cable continues, and against runs found by
// geometry if the net gives its own.

#include <gtest/gtest.h>

#include <algorithm>

#include "taut/design/builtin_nets.hpp"
#include "taut/net/cable_runs.hpp"

namespace {

using namespace taut;

TEST(CableRuns, OfAGridAreItsLines) {
    const CableNet net = hypar(4, 6);
    const std::vector<std::vector<int>> runs = cable_runs(net);
    // A line across n nodes has n + 1 edges, those at its supports among them.
    std::vector<size_t> sizes;
    std::ranges::transform(runs, std::back_inserter(sizes), &std::vector<int>::size);
    std::ranges::sort(sizes);
    EXPECT_EQ(sizes, (std::vector<size_t>{5, 5, 5, 5, 5, 5, 7, 7, 7, 7}));
    std::vector<int> all;
    for (const std::vector<int>& run : runs) {
        all.insert(all.end(), run.begin(), run.end());
    }
    std::ranges::sort(all);
    EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
    EXPECT_EQ(std::ssize(all), net.edge_count());
}

TEST(CableRuns, HaveTwoEdgesAtTheLeast) {
    const std::vector<std::vector<int>> runs = cable_runs(hypar(1, 1));
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].size(), 2U);
    EXPECT_EQ(runs[1].size(), 2U);
}

TEST(CableRuns, AreThoseOfTheNetIfItGivesAny) {
    CableNetData data = hypar(3, 3).data();
    data.runs = {{.name = "warp", .edges = {4, 2}}, {.name = "", .edges = {7}}};
    EXPECT_EQ(cable_runs(CableNet(data)), (std::vector<std::vector<int>>{{4, 2}, {7}}));
}

}  // namespace
