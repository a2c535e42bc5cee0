// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against points of another cable, or without their standard deviation.

#include "taut/io/sag_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/small_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

TEST(SagCsv, HasManyPointsOfAnEdge) {
    const auto points = parse_sag_points(
        two_node_net(), "edge,x,y,z,std\nab,0.2,0,0.1,0.002\nab,0.5,0,0.1,0.003\n", "f.csv", 0.0);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[1].edge, 2);
    EXPECT_EQ(points[1].position.x(), 0.5);
    EXPECT_EQ(points[1].std_dev, 0.003);
    EXPECT_EQ(parse_sag_points(two_node_net(), "ab,0.2,0,0.1\n", "f.csv", 1e-3)[0].std_dev, 1e-3);
}

TEST(SagCsv, IsRefusedWithLineAndRule) {
    expect_refused("f.csv",
                   {{"xy,0,0,0,1\n", ":1: 'xy' is no edge..."},
                    {"ab,0,0,0\n", ":1: the point has no standard..."},
                    {"ab,0,0,0,0\n", ":1: std is '0', expected a..."},
                    {"ab,0,0,high,1\n", ":1: z is 'high'..."}},
                   [](const std::string& text) {
                       return parse_sag_points(two_node_net(), text, "f.csv", 0.0);
                   });
}

}  // namespace
