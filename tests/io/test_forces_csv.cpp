// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against readings that are put on another edge or in another unit, and against files that
// are believed though they are not of this kind.

#include "taut/io/forces_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/small_nets.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using testing::HasSubstr;

TEST(ForcesCsv, IsReadByTheNamesOfEdges) {
    const auto readings = parse_force_measurements(
        two_node_net(), "edge,tension,std\nab,1500,30\n# a cell that was moved\n\"aA\",2000,50\n",
        "f.csv");
    ASSERT_EQ(readings.size(), 2U);
    EXPECT_EQ(readings[0].edge, 2);
    EXPECT_EQ(readings[0].tension, 1500.0);
    EXPECT_EQ(readings[0].std, 30.0);
    EXPECT_EQ(readings[1].edge, 0);
}

TEST(ForcesCsv, MayLeaveOutHeaderAndDeviationsAndTellAUnit) {
    const auto readings = parse_force_measurements(two_node_net(),
                                                   "\xEF\xBB\xBF"
                                                   "ab;1.5\r\nbD;2\r\n",
                                                   "f.csv", {.unit = 1e3, .relative_std = 0.01});
    ASSERT_EQ(readings.size(), 2U);
    EXPECT_EQ(readings[0].tension, 1500.0);
    EXPECT_DOUBLE_EQ(readings[0].std, 15.0);
    EXPECT_EQ(readings[1].edge, 4);
    EXPECT_EQ(parse_force_measurements(two_node_net(), "ab,0\n", "f.csv", {.std = 20.0})[0].std,
              20.0);
}

TEST(ForcesCsv, AListOfEdgesIsNoReadings) {
    EXPECT_TRUE(is_edge_list("edge\nab\n", "f.csv"));
    EXPECT_FALSE(is_edge_list("edge,tension\nab,3\n", "f.csv"));
    EXPECT_THAT(parse_edge_list(two_node_net(), "edge\nbD\n\nab\n", "f.csv"),
                testing::ElementsAre(4, 2));
    EXPECT_THAT(parse_edge_list(two_node_net(), "bD\n", "f.csv"), testing::ElementsAre(4));
}

TEST(ForcesCsv, AUnitThatIsMostLikelyAnotherIsNamed) {
    const CableNet tense = two_node_net();
    const double designed = tensions(tense, tense.unstressed_lengths(), tense.nodes())(2);
    const auto told_of = [&](double part) {
        return force_unit_warning(tense, {{.edge = 2, .tension = part * designed, .std = 1.0}},
                                  "f.csv");
    };
    EXPECT_EQ(told_of(1.0), "");
    EXPECT_EQ(told_of(0.5), "");
    EXPECT_THAT(told_of(0.1), HasSubstr("is their unit the one told?"));  // kgf
    EXPECT_THAT(input_error_of([&] { return told_of(1e-3); }),
                AllOf(HasSubstr("f.csv: "), HasSubstr("--force-unit kN")));
}

class RefusedForces : public testing::TestWithParam<BadText> {};

TEST_P(RefusedForces, WithLineAndRule) {
    EXPECT_THAT(input_error_of([] {
                    return parse_force_measurements(two_node_net(), GetParam().text, "f.csv");
                }),
                HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    ForcesCsv, RefusedForces,
    testing::Values(BadText{"Empty", "", "f.csv: holds no reading"},
                    BadText{"HeaderAlone", "edge,tension\n", "f.csv: holds no reading"},
                    BadText{"UnknownEdge", "edge,tension\nxy,3\n", "f.csv:2: 'xy' is no edge"},
                    BadText{"Twice", "ab,3\nbD,4\nab,5\n", "f.csv:3: names edge 'ab' a second"},
                    BadText{"Negative", "ab,-3\n", "f.csv:1: tension is '-3'"},
                    BadText{"NotANumber", "ab,nan\n", "f.csv:1: tension is 'nan'"},
                    BadText{"Infinite", "ab,1e999\n", "f.csv:1: tension is '1e999'"},
                    BadText{"BeyondAllCables", "ab,1e308\n", "f.csv:1: the tension is 1e+308 N"},
                    BadText{"FinerThanRounding", "ab,3,1e-200\n",
                            "f.csv:1: the standard deviation is 1e-200 N"},
                    BadText{"NoDeviation", "ab,3,0\n", "f.csv:1: std is 0"},
                    BadText{"ZeroOfWhichAPart", "ab,0\n", "f.csv:1: tension is 0"},
                    BadText{"TooManyFields", "ab,3,1,7\n", "f.csv:1: has 4 fields"},
                    BadText{"TooFewFields", "ab,3,1\nbD,3\n", "f.csv:2: has 2 fields"},
                    BadText{"EdgesAlone", "ab\n", "f.csv:1: has 1 fields"}),
    [](const auto& bad) { return bad.param.name; });

TEST(ForcesCsv, RefusesEdgeListsThatAreNone) {
    const auto refused = [](const char* text) {
        return input_error_of([&] { return parse_edge_list(two_node_net(), text, "taut.txt"); });
    };
    EXPECT_THAT(refused(""), HasSubstr("taut.txt: names no edge"));
    EXPECT_THAT(refused("ab\nab\n"), HasSubstr("taut.txt:2: names edge 'ab' a second"));
    EXPECT_THAT(refused("ab,3\n"), HasSubstr("taut.txt:1: has 2 fields"));
    EXPECT_THAT(refused("edge\nedge\n"), HasSubstr("taut.txt:2: 'edge' is no edge"));
}

}  // namespace
