// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against force measurements on another edge or in another unit.

#include "taut/io/forces_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/small_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

TEST(ForcesCsv, AreReadByTheNamesOfEdges) {
    const auto measurements = parse_force_measurements(
        two_node_net(), "edge,tension,std\nab,1500,30\n\"aA\",2000,50\n", "f.csv");
    ASSERT_EQ(measurements.size(), 2U);
    EXPECT_EQ(measurements[0].edge, 2);
    EXPECT_EQ(measurements[0].tension, 1500.0);
    EXPECT_EQ(measurements[0].std_dev, 30.0);
    EXPECT_EQ(measurements[1].edge, 0);
}

TEST(ForcesCsv, AreInTheUnitAndWithTheDeviationOfTheFormat) {
    const auto measurement = [](const char* text, const ForceFormat& format) {
        return parse_force_measurements(two_node_net(), text, "f.csv", format).front();
    };
    EXPECT_EQ(measurement("ab;1.5\n", {.unit = 1e3}).tension, 1500.0);
    EXPECT_DOUBLE_EQ(measurement("ab;1.5\n", {.unit = 1e3, .relative_std = 0.01}).std_dev, 15.0);
    EXPECT_EQ(measurement("ab,0\n", {.std_dev = 20.0}).std_dev, 20.0);
}

TEST(ForcesCsv, AreNoListOfEdges) {
    EXPECT_TRUE(is_edge_list("edge\nab\n", "f.csv"));
    EXPECT_FALSE(is_edge_list("edge,tension\nab,3\n", "f.csv"));
    EXPECT_THAT(parse_edge_list(two_node_net(), "edge\nbD\n\nab\n", "f.csv"),
                testing::ElementsAre(4, 2));
}

TEST(ForcesCsv, AreRefusedWithLineAndRule) {
    expect_refused("f.csv",
                   {{"edge,tension\nxy,3\n", ":2: 'xy' is no edge..."},
                    {"ab,3\nbD,4\nab,5\n", ":3: names edge 'ab' a second time, first in line 1..."},
                    {"ab,-3\n", ":1: tension is '-3', expected 0 or more..."},
                    {"ab,1e308\n", ":1: the tension is 1e+308 N..."},
                    {"ab,3,1e-200\n", ":1: the standard deviation is 1e-200 N..."},
                    {"ab,3,0\n", ":1: std is 0..."},
                    {"ab,0\n", ":1: tension is 0..."},
                    {"ab\n", ":1: has 1 fields, expected edge,tension[,std]..."}},
                   [](const std::string& text) {
                       return parse_force_measurements(two_node_net(), text, "f.csv");
                   });
}

}  // namespace
