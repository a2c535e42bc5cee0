// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against samples that are moved the wrong way, or by noise.

#include "estimation/prestress_shift.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace taut;

/// Fits whose common parameter is N(0, 1) and whose tension is 1000 N + 100 N times it. The other
/// common parameter has nothing to do with it.
std::vector<PerturbedFit> fits(int count, double slope, double noise) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::vector<PerturbedFit> result;
    for (int k = 0; k < count; ++k) {
        const double number = normal(random);
        const Eigen::Vector2d common(number, normal(random));
        result.push_back({.iterate = {.form = Points::Constant(3, 2, 7.0),
                                      .deviations = Eigen::VectorXd::Constant(4, 1e-3 * number),
                                      .loads = Points::Zero(3, 2),
                                      .common = common},
                          .mean_tension = 1000.0 + 100.0 * number,
                          .half_log_determinant = slope * number + noise * normal(random)});
    }
    return result;
}

// Weights exp(-a x) move a standard normal number by -a.
TEST(PrestressShift, IsThatOfWeightsOnANormalDistribution) {
    const auto shift = prestress_shift(fits(4000, -0.8, 0.1));
    ASSERT_TRUE(shift);
    EXPECT_NEAR(shift->by.common(0), 0.8, 0.04);
    EXPECT_NEAR(shift->by.common(1), 0.0, 0.04);
    EXPECT_NEAR(shift->by.deviations(2), 0.8e-3, 0.04e-3);
    EXPECT_EQ(shift->by.form.norm(), 0.0);
    EXPECT_NEAR(shift->size, 0.8, 0.04);
}

TEST(PrestressShift, IsNoneWhereOnlyChanceShowsOne) {
    EXPECT_FALSE(prestress_shift(fits(40, 0.05, 1.0)));
    EXPECT_FALSE(prestress_shift(fits(10, 0.8, 0.1)));
    EXPECT_FALSE(prestress_shift(fits(40, 0.0, 0.0)));
}

}  // namespace
