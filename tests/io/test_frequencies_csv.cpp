// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against frequencies of another edge or mode.

#include "taut/io/frequencies_csv.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/small_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

TEST(FrequenciesCsv, AreOfTheFirstModeAndHaveAPartAsDeviationUnlessGiven) {
    const auto short_form = parse_frequencies(two_node_net(), "ab,12.5\n", "f.csv", 0.02);
    ASSERT_EQ(short_form.size(), 1U);
    EXPECT_EQ(short_form[0].edge, 2);
    EXPECT_EQ(short_form[0].mode, 1);
    EXPECT_DOUBLE_EQ(short_form[0].std_dev, 0.25);
    const auto all =
        parse_frequencies(two_node_net(), "edge,frequency,mode,std\nab,25,2,0.1\n", "f.csv");
    EXPECT_EQ(all[0].mode, 2);
    EXPECT_EQ(all[0].std_dev, 0.1);
}

TEST(FrequenciesCsv, WithoutAnyStandardDeviationAreRefused) {
    EXPECT_THAT(
        input_error_of([] { return parse_frequencies(two_node_net(), "ab,12\n", "f.csv", 0.0); }),
        testing::StartsWith("f.csv:1: the frequency has no positive standard deviation"));
}

TEST(FrequenciesCsv, AreRefusedWithLineAndRule) {
    expect_refused(
        "f.csv",
        {{"edge,frequency\nxy,3\n", ":2: 'xy' is no edge..."},
         {"ab,3\nab,5\n", ":2: names edge 'ab' a second time..."},
         {"ab,0\n", ":1: frequency is '0', expected 0.01 to..."},
         {"ab,3,1.5\n", ":1: mode is '1.5', expected the number..."},
         {"ab,3,0\n", ":1: mode is '0'..."},
         {"ab,3,1,0\n", ":1: std is '0', expected a positive..."}},
        [](const std::string& text) { return parse_frequencies(two_node_net(), text, "f.csv"); });
}

}  // namespace
