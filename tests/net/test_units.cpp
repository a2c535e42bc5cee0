// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against quantities of the wrong size (5 mm taken for 5 m), typing errors taken for
// numbers, and lengths that change in their last bit when a file stores them as text.

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
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace taut;

/// Any double that a quantity may have: all bit patterns are equally likely.
rc::Gen<double> finite_doubles() {
    return rc::gen::suchThat(
        rc::gen::map(rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()),
                     [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
        [](double x) { return std::abs(x) <= 1e15; });
}

using Parse = double (*)(std::string_view);

TEST(ParseQuantities, TakeNumbersWithUnits) {
    const std::vector<std::tuple<Parse, const char*, double>> cases{
        {parse_length, "5mm", 0.005},
        {parse_length, "1.2cm", 0.012},
        {parse_length, "0.005m", 0.005},
        {parse_length, "0.25", 0.25},
        {parse_length, "0.5 mm", 0.0005},
        {parse_length, "7  m", 7.0},
        {parse_length, "-2mm", -0.002},
        {parse_length, "1e-3m", 0.001},
        {parse_length, "2.5E+1mm", 0.025},
        {parse_force, "200kN", 200e3},
        {parse_force, "0.2 MN", 200e3},
        {parse_force, "50N", 50.0},
        {parse_force, "50", 50.0},
        {parse_force, "1e12kN", 1e15},
        {parse_stress, "205GPa", 205e9},
        {parse_stress, "205000 MPa", 205e9},
        {parse_stress, "205000N/mm2", 205e9},
        {parse_stress, "2.05e11", 205e9},
        {parse_stress, "3kPa", 3000.0},
        {parse_part, "5%", 0.05},
        {parse_temperature, "10K", 10.0},
        {parse_memory, "8GiB", 8589934592.0},
        {parse_memory, "1.5 MB", 1.5e6}};
    for (const auto& [parse, text, value] : cases) {
        EXPECT_EQ(parse(text), value) << text;
    }
}

TEST(ParseQuantities, RefuseOtherTextsAndNameThem) {
    const std::vector<std::pair<Parse, std::vector<std::string>>> cases{
        {parse_length,
         {"",      " ",     "mm",     "5km",   "5MM",   "5mmm",    "5 m m",  "5mm ",  " 5mm",
          "5\tmm", "+5mm",  "--5mm",  "5,5mm", "0x5mm", "five mm", "5mm,",   "5 5mm", "1e400m",
          "nan",   "nanmm", "-infmm", "5\"",   "5'",    "%5mm",    "1e308m", "-1e16m"}},
        {parse_force, {"", "kN", "5m", "5 k N", "inf", "5GPa ", "1e999kN", "1e308kN"}},
        {parse_stress, {"", "GPa", "5kN", "5gpa", "nan", "5 bar"}},
        {parse_part, {"5", "5mm"}},
        {parse_temperature, {"5", "5%"}},
        {parse_memory, {"5", "5 kB", "1e9TB"}}};
    for (const auto& [parse, texts] : cases) {
        for (const std::string& text : texts) {
            const auto parsed = [&, parse = parse] { static_cast<void>(parse(text)); };
            EXPECT_THAT(parsed, testing::ThrowsMessage<std::invalid_argument>(
                                    testing::AllOf(testing::HasSubstr(fmt::format("'{}'", text)),
                                                   testing::HasSubstr("expected"))));
        }
    }
}

RC_GTEST_PROP(ParseLength, ReadsWholeMillimetresAsTheNearestDouble, ()) {
    const int millimetres = *rc::gen::inRange(-10'000'000, 10'000'000);
    const std::string number = std::to_string(millimetres);
    RC_ASSERT(parse_length(number + "mm") == std::stod(number + "e-3"));
}

TEST(FormatLength, WritesTheShortestNumberOfMillimetresWithoutRoundingErrors) {
    for (const auto& [metres, text] : {std::pair{0.005, "5mm"},
                                       {5.0, "5000mm"},
                                       {0.0, "0mm"},
                                       {-0.0023, "-2.3mm"},
                                       {0.0637, "63.7mm"},
                                       {parse_length("1.0000000000000007mm"), "1mm"},
                                       {-0.1 - 0.2, "-300mm"},
                                       {0.00123456789012, "1.23456789012mm"},
                                       {1e308, "1e+308m"}}) {
        EXPECT_EQ(format_length(metres), text);
    }
}

TEST(FormatLengthExactly, WritesMetresIfNoNumberOfMillimetresIsReadBackAsTheSame) {
    ASSERT_NE(2.1 / 1000.0, 0.0021);
    EXPECT_EQ(format_length_exactly(0.0021), "0.0021m");
    EXPECT_EQ(format_length_exactly(1e308), "1e+308m");
}

RC_GTEST_PROP(FormatLength, GivesBackWhatAPersonWrote, ()) {
    // 63.7 mm is one of those where metres times 1000 is not the number that was written.
    const int tenths = *rc::gen::oneOf(rc::gen::just(637), rc::gen::inRange(1, 100'000));
    const std::string number =
        std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10));
    RC_ASSERT(format_length(parse_length(number + "mm")) == number + "mm");
}

RC_GTEST_PROP(FormatLength, IsReadBackWithinRoundingAndExactlyToTheLastBit, ()) {
    // Any number, and lengths of cables with all their bits set.
    const auto nanometres = *rc::gen::inRange<std::int64_t>(1, 10'000'000'000);
    for (const double metres :
         {*finite_doubles(), static_cast<double>(nanometres) / 1e9 * 1.000000059604644775390625}) {
        RC_ASSERT(std::abs(parse_length(format_length(metres)) - metres) <=
                  1e-12 * std::abs(metres));
        RC_ASSERT(std::bit_cast<std::uint64_t>(parse_length(format_length_exactly(metres))) ==
                  std::bit_cast<std::uint64_t>(metres));
    }
}

}  // namespace
