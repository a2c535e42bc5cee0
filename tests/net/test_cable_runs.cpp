// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against runs of cable that end where the cable continues, and against runs found by
// geometry if the net gives its own, and runs that slide where they cannot.

#include <gmock/gmock.h>
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

/// The lines of a grid as runs, the first of which slides.
CableNetData sliding_grid(double friction) {
    CableNetData data = hypar(2, 3).data();
    for (const std::vector<int>& edges : cable_runs(hypar(2, 3))) {
        data.runs.push_back({.name = "", .edges = edges, .slides_at = {}});
    }
    CableRun& run = data.runs[0];
    for (size_t i = 0; i + 1 < run.edges.size(); ++i) {
        const Edge& after = data.edges[run.edges[i + 1]];
        for (const int node : data.edges[run.edges[i]]) {
            if (std::ranges::find(after, node) != after.end()) {
                run.slides_at.push_back(node);
            }
        }
    }
    run.friction = friction;
    return data;
}

TEST(CableRuns, SlideBetweenEdgesThatFollowEachOther) {
    CableNetData data = sliding_grid(0.2);
    const CableRun run = data.runs[0];
    data.runs[0].slides_at = {run.slides_at[1]};
    const CableNet net(data);
    ASSERT_EQ(net.sliding_nodes().size(), 1U);
    const SlidingNode& at = net.sliding_nodes()[0];
    EXPECT_EQ(at.node, run.slides_at[1]);
    EXPECT_EQ(at.before, run.edges[1]);
    EXPECT_EQ(at.after, run.edges[2]);
    EXPECT_EQ(at.friction, 0.2);
}

TEST(CableRuns, ThatSlideChangeTheStatics) {
    const std::string fingerprint = CableNet(sliding_grid(0.2)).fingerprint();
    EXPECT_NE(fingerprint, hypar(2, 3).fingerprint());
    EXPECT_NE(fingerprint, CableNet(sliding_grid(0.1)).fingerprint());
    CableNetData data = sliding_grid(0.2);
    data.runs[0].slides_at.pop_back();
    EXPECT_NE(fingerprint, CableNet(data).fingerprint());
}

TEST(CableRuns, ThatCannotSlideAreRefused) {
    const auto refused = [](const auto& change) {
        return [change] {
            CableNetData data = sliding_grid(0.0);
            change(data.runs[0], data);
            CableNet{std::move(data)};
        };
    };
    const auto says = [](const char* text) {
        return testing::ThrowsMessage<NetError>(testing::HasSubstr(text));
    };
    EXPECT_THAT(
        refused([](CableRun& run, CableNetData& data) { run.slides_at = {data.supports[0]}; }),
        says("expected a node between two edges of the run that follow each other"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) { run.slides_at[1] = run.slides_at[0]; }),
                says("slides_at[1]: lists node"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) { run.slides_at[0] = 99; }),
                says("runs[0]: slides_at[0]: is 99, expected the index of one of"));
    EXPECT_THAT(
        refused([](CableRun& run, CableNetData&) { std::swap(run.edges[0], run.edges[1]); }),
        says("follow each other in its list"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) {
                    run.friction = NAN;
                    run.slides_at.clear();
                }),
                says("friction is nan, expected a number of 0 to 10"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) {
                    run.ratios = {1.0, 1.0};
                    run.slides_at.clear();
                }),
                says("has ratios, but no slides_at"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) { run.ratios = {1.0}; }),
                says("has 1 ratios, expected 2, one a node where it slides"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData&) { run.ratios = {1.0, 0.0}; }),
                says("holds the ratio 0, expected one of 0.01 to 100"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData& data) {
                    // across one node of the grid, and back
                    const int node = run.slides_at[0];
                    std::vector<int> star;
                    for (int e = 0; e < std::ssize(data.edges); ++e) {
                        if (std::ranges::find(data.edges[e], node) != data.edges[e].end()) {
                            star.push_back(e);
                        }
                    }
                    data.runs = {{.name = "star", .edges = star, .slides_at = {node}}};
                }),
                says("and leaves it by the same, expected a path"));
    EXPECT_THAT(refused([](CableRun& run, CableNetData& data) {
                    data.kind.assign(data.edges.size(), EdgeKind::cable);
                    data.kind[run.edges[1]] = EdgeKind::strut;
                }),
                says("which is a strut"));
}

}  // namespace
