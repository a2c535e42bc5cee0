// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the power of tests against Boost's non-central distributions.

#include <gtest/gtest.h>

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <limits>

#include "estimation/detectable_error.hpp"

namespace {

using namespace taut;

double power_of(double noncentrality, double threshold, int degrees_of_freedom) {
    const boost::math::non_central_chi_squared distribution(degrees_of_freedom, noncentrality);
    return boost::math::cdf(boost::math::complement(distribution, threshold));
}

TEST(DetectableError, HasThePowerOfTheNonCentralDistribution) {
    for (const double threshold : {11.0, 25.0}) {
        const Eigen::MatrixXd of_edge = Eigen::MatrixXd::Constant(1, 1, 4e6);
        const double edge = detectable_error({TestedItem{of_edge}}, threshold, 1);
        EXPECT_NEAR(power_of(4e6 * edge * edge, threshold, 1), detection_power, 1e-4);
        const Eigen::MatrixXd of_support = 9e6 * Eigen::MatrixXd::Identity(3, 3);
        const double support = detectable_error({TestedItem{of_support}}, threshold, 3);
        EXPECT_NEAR(power_of(9e6 * support * support, threshold, 3), detection_power, 1e-4);
    }
}

TEST(DetectableError, IsOfARandomPlace) {
    const TestedItem seen{Eigen::MatrixXd::Constant(1, 1, 4e6)};
    const TestedItem hidden{Eigen::MatrixXd::Zero(1, 1)};
    const double all = detectable_error({seen, seen}, 11.0, 1);
    // One in ten is not seen, but for false alarms.
    std::vector<TestedItem> most(9, seen);
    most.push_back(hidden);
    const double of_most = detectable_error(most, 11.0, 1);
    EXPECT_GT(of_most, all);
    const double power =
        0.9 * power_of(4e6 * of_most * of_most, 11.0, 1) + 0.1 * power_of(1e-12, 11.0, 1);
    EXPECT_NEAR(power, detection_power, 1e-4);
    EXPECT_TRUE(std::isinf(detectable_error({seen, hidden}, 11.0, 1)));
    EXPECT_TRUE(std::isinf(detectable_error(std::vector<TestedItem>{}, 11.0, 1)));
}

TEST(DetectableError, IsNoneWhereRoundingLeavesNoVariance) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::vector<TestedItem> items{{Eigen::MatrixXd::Constant(1, 1, infinite)},
                                        {Eigen::MatrixXd::Constant(1, 1, 1e6)}};
    EXPECT_EQ(detectable_error(items, 10.0, 1), infinite);
}

TEST(DetectableError, OfAnEstimateIsOutsideItsBound) {
    const double error = detectable_error(std::vector<BoundedEstimate>{{4e-3, 1e-3}});
    EXPECT_NEAR(error, 4e-3 + 0.8416212 * 1e-3, 1e-7);
}

}  // namespace
