// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against strokes, loads, weights and tensions of other edges and nodes than were meant.

#include "taut/io/adjustment_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/small_nets.hpp"
#include "taut/adjustment/request_error.hpp"

namespace taut {
namespace {

using test::expect_refused;
using test::two_node_net;

TEST(StrokeRanges, AreOfNamedEdgesAndHoldZero) {
    const auto read = [](const std::string& text) {
        return parse_stroke_ranges(two_node_net(), text, "s.csv");
    };
    const auto ranges = read("edge,shortest,longest\nbD,-0.004,0.01\naA,0,0.02\n");
    ASSERT_EQ(ranges.size(), 2U);
    EXPECT_EQ(ranges[0].edge, 4);
    EXPECT_EQ(ranges[0].shortest, -0.004);
    EXPECT_EQ(ranges[0].longest, 0.01);
    expect_refused("s.csv",
                   {{"edge,shortest,longest\naA,0.001,0.002\n",
                     ":2: the strokes go from 0.001 to 0.002 m, expected a range that holds 0"},
                    {"aA,-1,1\naA,-1,1\n", ":2: names edge 'aA' a second time..."},
                    {"aA,-1000,1\n", ":1: shortest is '-1000', expected a number of less than..."}},
                   read);
}

TEST(Loads, AreOfFreeNodes) {
    const auto read = [](const std::string& text) {
        return parse_loads(two_node_net(), text, "l.csv");
    };
    const Points loads = read("id,x,y,z\nb,1,2,-3\nA,0,0,0\n");
    EXPECT_EQ(loads.col(3), Eigen::Vector3d(1, 2, -3));
    EXPECT_TRUE(loads.leftCols(3).isZero());
    expect_refused("l.csv",
                   {{"id,x,y,z\nnowhere,0,0,-1\n", ":2: 'nowhere' is no node..."},
                    {"A,0,0,-1\n", ":1: node 'A' is a support, which takes a load by itself..."},
                    {"b,0,0,1e12\n", ":1: z is '1e12', expected a number of less than 1e+12"}},
                   read);
}

TEST(WeightsOfNodes, AreOfFreeNodesAndNotNegative) {
    const auto read = [](const std::string& text) {
        return parse_node_weights(two_node_net(), text, "w.csv");
    };
    const auto weights = read("id,normal,tangential\nb,1000,0\n");
    ASSERT_EQ(weights.size(), 1U);
    EXPECT_EQ(weights[0].node, 3);
    EXPECT_EQ(weights[0].normal, 1000.0);
    EXPECT_EQ(weights[0].tangential, 0.0);
    expect_refused("w.csv",
                   {{"nowhere,1,1\n", ":1: 'nowhere' is no node..."},
                    {"a,1,1\na,2,1\n", ":2: names node 'a' a second time..."},
                    {"A,1,1\n", ":1: node 'A' is a support, which does not move..."},
                    {"a,-1,1\n", ":1: the weights are -1 and 1, expected 0 or more"},
                    {"a,1\n", ":1: has 2 fields..."}},
                   read);
}

TEST(TargetTensions, AreOfNamedEdgesWithTheirToleranceOrThatOfAll) {
    const auto read = [](const std::string& text) {
        return parse_target_tensions(two_node_net(), text, "t.csv");
    };
    const auto whole = read("edge,tension,tolerance\nab,2500,20\n");
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].edge, 2);
    EXPECT_EQ(whole[0].tension, 2500.0);
    EXPECT_EQ(whole[0].tolerance.value, 20.0);
    EXPECT_FALSE(whole[0].tolerance.is_part);
    EXPECT_TRUE(read("ab,2500\n")[0].tolerance.is_part);
    expect_refused("t.csv",
                   {{"edge,tension\nab,100\nab,200\n", ":3: names edge 'ab' a second time..."},
                    {"ab,-100\n", ":1: tension is '-100', expected more than 0"},
                    {"ab,100,0\n", ":1: tolerance is '0', expected more than 0"}},
                   read);
}

TEST(ReadTarget, HasAUnitOnlyWhereItIsASurface) {
    EXPECT_EQ(read_target(two_node_net(), "", 1.0).points, two_node_net().nodes());
    EXPECT_THAT([] { (void)read_target(two_node_net(), "form.csv", 1e-3); },
                testing::ThrowsMessage<RequestError>(testing::HasSubstr("is for a surface")));
}

}  // namespace
}  // namespace taut
