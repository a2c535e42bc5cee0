// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against numbers that the page shows other than they are.

#include "report/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace taut::report {
namespace {

TEST(NumberText, HasThreeSignificantDigits) {
    EXPECT_EQ(number_text(4.5678), "4.57");
    EXPECT_EQ(number_text(0.0123456), "0.0123");
    EXPECT_EQ(number_text(13.0), "13.0");
    EXPECT_EQ(number_text(138.49), "138");
    EXPECT_EQ(number_text(0.0), "0");
}

TEST(NumberText, CountsDigitsAfterRounding) {
    EXPECT_EQ(number_text(9.996), "10.0");
    EXPECT_EQ(number_text(0.09996), "0.100");
    EXPECT_EQ(number_text(0.00099996), "0.00100");
}

TEST(NumberText, KeepsAllDigitsBeforeThePoint) {
    EXPECT_EQ(number_text(1234.4), "1234");
    EXPECT_EQ(number_text(987654.0), "987654");
}

TEST(NumberText, WritesPowersOfTenWhereZerosWouldHideTheNumber) {
    EXPECT_EQ(number_text(1.7e-8), "1.70×10⁻⁸");
    EXPECT_EQ(number_text(-2.346e12), "−2.35×10¹²");
    EXPECT_EQ(number_text(0.00012345), "1.23×10⁻⁴");
}

TEST(NumberText, HasATrueMinusSign) {
    EXPECT_EQ(number_text(-0.5), "−0.500");
}

TEST(NumberText, ShowsADashForWhatIsNotFinite) {
    EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "–");
    EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "–");
    EXPECT_EQ(short_number(std::numeric_limits<double>::infinity()), "–");
}

TEST(ShortNumber, LeavesOutZerosAtTheEndOfAFractionOnly) {
    EXPECT_EQ(short_number(1.7e-8), "1.7×10⁻⁸");
    EXPECT_EQ(short_number(2e-8), "2×10⁻⁸");
    EXPECT_EQ(short_number(5.0), "5");
    EXPECT_EQ(short_number(4.7), "4.7");
    EXPECT_EQ(short_number(500.0), "500");
    EXPECT_EQ(short_number(0.0), "0");
    EXPECT_EQ(short_number(100200.0), "100200");
}

TEST(NumberText, TurnsMetresAndPartsIntoTheirUnits) {
    EXPECT_EQ(millimetres(0.00467), "4.67");
    EXPECT_EQ(percent(0.0025), "0.250");
}

TEST(Counted, HasAPluralForAllButOne) {
    EXPECT_EQ(counted(1, "edge"), "1 edge");
    EXPECT_EQ(counted(0, "edge"), "0 edges");
    EXPECT_EQ(counted(536, "edge"), "536 edges");
}

}  // namespace
}  // namespace taut::report
