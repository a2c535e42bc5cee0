// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths of the wrong size: 5 mm taken for 5 m, a typing error taken for a number,
// a length that changes in its last bit when a file keeps it as text.

#include "taut/net/units.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace {

using taut::format_length;
using taut::format_length_exactly;
using taut::parse_force;
using taut::parse_length;
using taut::parse_stress;

/// Any double that a quantity may have: all bit patterns are equally likely.
rc::Gen<double> finite_doubles() {
    return rc::gen::suchThat(
        rc::gen::map(rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()),
                     [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
        [](double x) { return std::abs(x) <= 1e15; });
}

TEST(ParseLength, TakesMillimetresCentimetresAndMetres) {
    EXPECT_EQ(parse_length("5mm"), 0.005);
    EXPECT_EQ(parse_length("1.2cm"), 0.012);
    EXPECT_EQ(parse_length("0.005m"), 0.005);
}

TEST(ParseLength, TakesABareNumberForMetres) {
    EXPECT_EQ(parse_length("0.25"), 0.25);
    EXPECT_EQ(parse_length("3"), 3.0);
}

TEST(ParseLength, TakesBlanksBetweenNumberAndUnit) {
    EXPECT_EQ(parse_length("0.5 mm"), 0.0005);
    EXPECT_EQ(parse_length("7  m"), 7.0);
}

TEST(ParseLength, TakesSignsAndExponents) {
    EXPECT_EQ(parse_length("-2mm"), -0.002);
    EXPECT_EQ(parse_length("1e-3m"), 0.001);
    EXPECT_EQ(parse_length("2.5E+1mm"), 0.025);
}

RC_GTEST_PROP(ParseLength, ReadsWholeMillimetresAsTheDoubleNextToThem, ()) {
    const int millimetres = *rc::gen::inRange(-10'000'000, 10'000'000);
    const std::string number = std::to_string(millimetres);
    RC_ASSERT(parse_length(number + "mm") == std::stod(number + "e-3"));
}

class BadLength : public testing::TestWithParam<std::string> {};

TEST_P(BadLength, IsRefusedWithItsText) {
    try {
        const double length = parse_length(GetParam());
        FAIL() << "'" << GetParam() << "' was read as " << length << " m";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(fmt::format("'{}'", GetParam())));
        EXPECT_THAT(error.what(), testing::HasSubstr("expected"));
    }
}

INSTANTIATE_TEST_SUITE_P(Texts, BadLength,
                         testing::Values("", " ", "mm", "5km", "5MM", "5mmm", "5 m m", "5mm ",
                                         " 5mm", "5\tmm", "+5mm", "--5mm", "5,5mm", "0x5mm",
                                         "five mm", "5mm,", "5 5mm", "1e400m", "-1e400m", "nan",
                                         "nanmm", "inf", "-infmm", "5\"", "5'", "%5mm"));

TEST(FormatLengthExactly, WritesMetresWhereNoNumberOfMillimetresIsReadBackAsTheSame) {
    ASSERT_NE(2.1 / 1000.0, 0.0021);
    EXPECT_EQ(format_length_exactly(0.0021), "0.0021m");
    EXPECT_EQ(format_length_exactly(1e308), "1e+308m");
}

TEST(FormatLength, WritesMetresWhereMillimetresAreNoDouble) {
    EXPECT_EQ(format_length(1e308), "1e+308m");
}

TEST(FormatLength, LeavesOutTheRoundingErrorsOfALength) {
    ASSERT_NE(parse_length("1.0000000000000007mm"), 0.001);
    EXPECT_EQ(format_length(parse_length("1.0000000000000007mm")), "1mm");
    EXPECT_EQ(format_length(0.0021), "2.1mm");
    EXPECT_EQ(format_length(-0.1 - 0.2), "-300mm");
    EXPECT_EQ(format_length(0.00123456789012), "1.23456789012mm");
}

TEST(FormatLength, WritesTheShortestNumberOfMillimetres) {
    EXPECT_EQ(format_length(0.005), "5mm");
    EXPECT_EQ(format_length(0.0005), "0.5mm");
    EXPECT_EQ(format_length(5.0), "5000mm");
    EXPECT_EQ(format_length(0.0), "0mm");
    EXPECT_EQ(format_length(-0.0023), "-2.3mm");
    EXPECT_EQ(format_length(0.0637), "63.7mm");
}

RC_GTEST_PROP(FormatLength, GivesBackWhatAPersonWrote, ()) {
    // 63.7 mm is one of those where metres times 1000 is not the number that was written.
    const int tenths = *rc::gen::oneOf(rc::gen::just(637), rc::gen::inRange(1, 100'000));
    const std::string number =
        std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10));
    RC_ASSERT(format_length(parse_length(number + "mm")) == number + "mm");
}

RC_GTEST_PROP(FormatLength, IsReadBackToAPartInATrillion, ()) {
    const double metres = *finite_doubles();
    RC_ASSERT(std::abs(parse_length(format_length(metres)) - metres) <= 1e-12 * std::abs(metres));
}

RC_GTEST_PROP(FormatLengthExactly, IsReadBackToTheLastBit, ()) {
    const double metres = *finite_doubles();
    RC_ASSERT(std::bit_cast<std::uint64_t>(parse_length(format_length_exactly(metres))) ==
              std::bit_cast<std::uint64_t>(metres));
}

RC_GTEST_PROP(FormatLengthExactly, IsReadBackToTheLastBitForLengthsOfCables, ()) {
    const auto nanometres = *rc::gen::inRange<std::int64_t>(1, 10'000'000'000);
    const double metres = static_cast<double>(nanometres) / 1e9 * 1.000000059604644775390625;
    RC_ASSERT(parse_length(format_length_exactly(metres)) == metres);
}

TEST(ParseForce, TakesNewtonsKilonewtonsAndMeganewtons) {
    EXPECT_EQ(parse_force("200kN"), 200e3);
    EXPECT_EQ(parse_force("0.2 MN"), 200e3);
    EXPECT_EQ(parse_force("50N"), 50.0);
    EXPECT_EQ(parse_force("50"), 50.0);
}

TEST(ParseStress, TakesPascalsOfAllSizes) {
    EXPECT_EQ(parse_stress("205GPa"), 205e9);
    EXPECT_EQ(parse_stress("205000 MPa"), 205e9);
    EXPECT_EQ(parse_stress("205000N/mm2"), 205e9);
    EXPECT_EQ(parse_stress("2.05e11"), 205e9);
    EXPECT_EQ(parse_stress("3kPa"), 3000.0);
}

TEST(ParseForceAndStress, RefuseAnythingElseAndNameIt) {
    for (const std::string text : {"", "kN", "5m", "5 k N", "nan", "inf", "5GPa ", "1e999kN"}) {
        EXPECT_THROW(static_cast<void>(parse_force(text)), std::invalid_argument) << text;
    }
    for (const std::string text : {"", "GPa", "5kN", "5gpa", "nan"}) {
        EXPECT_THROW(static_cast<void>(parse_stress(text)), std::invalid_argument) << text;
    }
    EXPECT_THAT([] { static_cast<void>(parse_stress("5 bar")); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("'5 bar'")));
}

TEST(ParseForce, RefusesWhatNothingBuiltHas) {
    EXPECT_THROW((void)parse_force("1e308kN"), std::invalid_argument);
    EXPECT_THROW((void)parse_length("1e308m"), std::invalid_argument);
    EXPECT_THROW((void)parse_length("-1e16m"), std::invalid_argument);
    EXPECT_EQ(parse_force("1e12kN"), 1e15);
}

}  // namespace
