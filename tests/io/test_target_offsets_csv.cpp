// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against an offset in another unit, of another target, or none at all.

#include "taut/io/target_offsets_csv.hpp"

#include <gmock/gmock.h>

#include "support/errors.hpp"

namespace taut {
namespace {

using test::input_error_of;

TEST(TargetOffsetsCsv, AreReadWithTheirUnits) {
    const auto offsets =
        parse_target_offsets("target,offset,std\nprism,3mm,0.2mm\n17,-0.005,0\n", "o.csv");
    ASSERT_EQ(offsets.size(), 2U);
    EXPECT_DOUBLE_EQ(offsets.at("prism").offset, 0.003);
    EXPECT_DOUBLE_EQ(offsets.at("prism").std_dev, 0.0002);
    EXPECT_DOUBLE_EQ(offsets.at("17").offset, -0.005);
    EXPECT_EQ(parse_target_offsets("a;1cm\n", "o.csv").at("a").std_dev, 0.0);
}

TEST(TargetOffsetsCsv, RefuseWhatTheyCannotMean) {
    const auto refusal = [](const char* text) {
        return input_error_of([&] { return parse_target_offsets(text, "o.csv"); });
    };
    EXPECT_EQ(refusal("a,3 horses\n"), "o.csv:1: offset is '3 horses', expected a length as 3mm");
    EXPECT_EQ(refusal("a,3mm,-1mm\n"),
              "o.csv:1: the offset is 0.003 +- -0.001 m, expected at most 0.5 m, and a standard "
              "deviation from 0 to 0.5 m: a number without unit is in metres");
    EXPECT_EQ(refusal("a,3mm\na,4mm\n"), "o.csv:2: gives the offset of 'a' a second time");
}

}  // namespace
}  // namespace taut
