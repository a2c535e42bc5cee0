// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a survey that is taken for a plan of targets, or the other way round.

#include "io/target_list.hpp"

#include <gmock/gmock.h>

#include "support/errors.hpp"

namespace taut {
namespace {

TEST(TargetList, HoldsTheNamesWithTheirLines) {
    const auto targets = parse_target_list("# north side\nA1\n\n \"B 2\" \r\n17\n", "plan.txt");
    ASSERT_TRUE(targets);
    ASSERT_EQ(targets->size(), 3U);
    EXPECT_EQ((*targets)[1].id, "B 2");
    EXPECT_EQ((*targets)[1].line, 4);
}

TEST(TargetList, IsNoneWhereTheFirstLineHoldsMore) {
    EXPECT_FALSE(parse_target_list("# exported\nA 1 2 3\n", "survey.txt"));
    EXPECT_EQ(
        test::input_error_of([] { return parse_target_list("A\nB\nC 1 2 3\n", "plan.txt"); }),
        "plan.txt:3: has 4 fields, expected the name of a node alone, as in the lines before");
    EXPECT_EQ(test::input_error_of([] { return parse_target_list("# nothing\n", "plan.txt"); }),
              "plan.txt: names no node, expected one a line, or a survey");
}

}  // namespace
}  // namespace taut
