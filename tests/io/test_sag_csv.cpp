// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against points of another cable, or without their standard deviation.

#include "taut/io/sag_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
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
    EXPECT_EQ(points[1].std, 0.003);
    EXPECT_EQ(parse_sag_points(two_node_net(), "ab,0.2,0,0.1\n", "f.csv", 1e-3)[0].std, 1e-3);
}

class RefusedPoints : public testing::TestWithParam<BadText> {};

TEST_P(RefusedPoints, WithLineAndRule) {
    EXPECT_THAT(input_error_of(
                    [] { return parse_sag_points(two_node_net(), GetParam().text, "f.csv", 0.0); }),
                testing::StartsWith("f.csv" + GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    SagCsv, RefusedPoints,
    testing::Values(BadText{"UnknownEdge", "xy,0,0,0,1\n", ":1: 'xy' is no edge"},
                    BadText{"NoDeviation", "ab,0,0,0\n", ":1: the point has no standard"},
                    BadText{"ZeroDeviation", "ab,0,0,0,0\n", ":1: std is '0', expected a"},
                    BadText{"NoNumber", "ab,0,0,high,1\n", ":1: z is 'high'"}),
    [](const auto& bad) { return bad.param.name; });

}  // namespace
