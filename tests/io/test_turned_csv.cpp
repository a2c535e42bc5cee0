// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against turns that are put on another edge, in another unit, or counted twice.

#include "taut/io/turned_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/small_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(TurnedCsv, IsReadByTheNamesOfEdges) {
    const auto turned = parse_turned(
        two_node_net(), "edge,stroke,std\nbD,0.004,0.0002\n# by hand\naA,-3e-3,0\n", "t.csv");
    ASSERT_EQ(turned.size(), 2U);
    EXPECT_EQ(turned[0].edge, 0);
    EXPECT_EQ(turned[0].stroke, -3e-3);
    EXPECT_EQ(turned[0].std_dev, 0.0);
    EXPECT_EQ(turned[1].edge, 4);
    EXPECT_EQ(turned[1].std_dev, 0.0002);
}

TEST(TurnedCsv, AddsUpThePassesOfAListOfAnyVersion) {
    for (const std::string list :
         {"number,crew,pass,step,edge,support,action,rotation,turns,stroke_mm,scale_reading_mm\n"
          "1,1,1,1,aA,A,lengthen,,0.5,2.5,2.5\n"
          "2,1,1,2,bD,D,shorten,,0.25,-1.25,-1.25\n"
          "3,1,2,3,aA,A,lengthen,,0.25,1.25,3.75\n",
          "crew,pass,moment,edge,sense,rotation,stroke_mm,turns\n"  // of 0.2.0
          "1,1,1,aA,lengthen,,2.5,0.5\n"
          "1,1,2,bD,shorten,,-1.25,0.25\n"
          "1,2,3,aA,lengthen,,1.25,0.25\n"}) {
        const auto turned = parse_turned(two_node_net(), list, "turns.csv");
        ASSERT_EQ(turned.size(), 2U);
        EXPECT_DOUBLE_EQ(turned[0].stroke, 3.75e-3);
        EXPECT_DOUBLE_EQ(turned[1].stroke, -1.25e-3);
    }
}

TEST(TurnedCsv, RefusesWhatCannotBeMeant) {
    const auto refused = [](const std::string& text, const std::string& line,
                            const std::string& words) {
        EXPECT_THAT([&] { static_cast<void>(parse_turned(two_node_net(), text, "t.csv")); },
                    ThrowsMessage<InputError>(
                        testing::AllOf(HasSubstr("t.csv"), HasSubstr(line), HasSubstr(words))))
            << text;
    };
    refused("edge,stroke\nab,0.001\n", "2", "not adjustable");
    refused("aA,0.001\naA,0.001\n", "2", "a second time, first in line 1");
    refused("pass,edge,stroke_mm\n1,aA,1\n1,aA,1\n", "3", "a second time in pass 1");
    refused("aA,3\n", "1", "in metres");
    refused("aA,0.001,-1\n", "1", "std");
    refused("aA,0.001,1\n", "1", "std");
    refused("edge,stroke_mm\naA,1\n", "1", "pass");
    refused("edge,stroke\n", "", "holds no turn");
}

}  // namespace
