// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against marks of an axis that are crooked, too many, or labelled other than where they
// stand.

#include "report/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace taut::report {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NiceTicks, AreMultiplesOfOneTwoOrFive) {
    EXPECT_THAT(nice_ticks(0.0, 1.0, 10).values,
                ElementsAre(0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0));
    EXPECT_THAT(nice_ticks(0.0, 1.0, 5).values, ElementsAre(0.0, 0.2, 0.4, 0.6, 0.8, 1.0));
    EXPECT_THAT(nice_ticks(0.0, 1.0, 4).values, ElementsAre(0.0, 0.5, 1.0));
    EXPECT_THAT(nice_ticks(0.0, 1.0, 1).values, ElementsAre(0.0, 1.0));
    EXPECT_THAT(nice_ticks(0.0, 13.8, 5).values, ElementsAre(0.0, 5.0, 10.0));
}

TEST(NiceTicks, LieWithinTheRange) {
    EXPECT_THAT(nice_ticks(-5.25, 5.25, 8).values, ElementsAre(-4.0, -2.0, 0.0, 2.0, 4.0));
    EXPECT_THAT(nice_ticks(0.5, 536.5, 10).values, ElementsAre(100.0, 200.0, 300.0, 400.0, 500.0));
    EXPECT_THAT(nice_ticks(12.1, 12.9, 1).values, IsEmpty());
}

TEST(NiceTicks, CountAnEndThatIsAMultipleButForRounding) {
    EXPECT_THAT(nice_ticks(0.1 + 0.2, 0.9, 3).labels, ElementsAre("0.4", "0.6", "0.8"));
    EXPECT_THAT(nice_ticks(0.1 + 0.2, 0.9, 6).labels,
                ElementsAre("0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9"));
}

TEST(NiceTicks, AreLabelledWithAsManyDecimalsAsTheirStep) {
    EXPECT_THAT(nice_ticks(-1.0, 1.0, 4).labels, ElementsAre("−1.0", "−0.5", "0.0", "0.5", "1.0"));
    EXPECT_THAT(nice_ticks(0.0, 0.06, 3).labels, ElementsAre("0.00", "0.02", "0.04", "0.06"));
    EXPECT_THAT(nice_ticks(0.0, 3000.0, 3).labels, ElementsAre("0", "1000", "2000", "3000"));
    EXPECT_THAT(nice_ticks(2600000.0, 2600001.0, 2).labels,
                ElementsAre("2600000.0", "2600000.5", "2600001.0"));
}

TEST(NiceTicks, AreLabelledWithPowersOfTenWhereTheStepIsVerySmallOrLarge) {
    EXPECT_THAT(nice_ticks(-2e-9, 2e-9, 4).labels,
                ElementsAre("−2×10⁻⁹", "−1×10⁻⁹", "0", "1×10⁻⁹", "2×10⁻⁹"));
    EXPECT_THAT(nice_ticks(0.0, 2e9, 2).labels, ElementsAre("0", "1×10⁹", "2×10⁹"));
}

TEST(NiceTicks, HaveNoStepBelowTheSmallest) {
    EXPECT_THAT(nice_ticks(0.5, 2.5, 10, 1.0).values, ElementsAre(1.0, 2.0));
    EXPECT_THAT(nice_ticks(0.5, 1.5, 10, 1.0).labels, ElementsAre("1"));
}

TEST(NiceTicks, AreNoneForARangeThatIsEmptyReversedOrNotFinite) {
    EXPECT_THAT(nice_ticks(1.0, 1.0, 5).values, IsEmpty());
    EXPECT_THAT(nice_ticks(2.0, 1.0, 5).values, IsEmpty());
    EXPECT_THAT(nice_ticks(0.0, 5e-324, 5).values, IsEmpty());
    EXPECT_THAT(nice_ticks(0.0, std::numeric_limits<double>::infinity(), 5).values, IsEmpty());
    EXPECT_THAT(nice_ticks(std::numeric_limits<double>::quiet_NaN(), 1.0, 5).values, IsEmpty());
}

TEST(NiceTicks, AreFewWhereTheRangeIsNoMoreThanRoundingErrors) {
    EXPECT_LE(nice_ticks(1e6, std::nextafter(1e6, 2e6), 5).values.size(), 6U);
    EXPECT_LE(nice_ticks(1e18, std::nextafter(1e18, 2e18), 5).values.size(), 6U);
}

RC_GTEST_PROP(NiceTicks, AreEvenlySpacedFewAndInOrder, ()) {
    const double low = 1e-3 * *rc::gen::inRange(-1'000'000, 1'000'000);
    const double range = std::pow(10.0, 0.01 * *rc::gen::inRange(-500, 500));
    const int intervals = *rc::gen::inRange(2, 12);
    const Ticks ticks = nice_ticks(low, low + range, intervals);
    RC_ASSERT(ticks.values.size() <= static_cast<size_t>(intervals) + 1);
    RC_ASSERT(ticks.labels.size() == ticks.values.size());
    for (std::size_t i = 1; i < ticks.values.size(); ++i) {
        const double step = ticks.values[1] - ticks.values[0];
        RC_ASSERT(step > 0.0);
        RC_ASSERT(std::abs(ticks.values[i] - ticks.values[i - 1] - step) < 1e-6 * step);
        RC_ASSERT(ticks.labels[i] != ticks.labels[i - 1]);
    }
}

}  // namespace
}  // namespace taut::report
