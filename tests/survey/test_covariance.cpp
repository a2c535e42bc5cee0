// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against correlations in another order than x y, x z, y z, and against those that no noise
// can have.

#include "survey/covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

namespace taut {
namespace {

const PlaceNoise noise{.std_dev = {1e-3, 2e-3, 4e-3}, .correlations = {0.5, -0.25, 0.1}};

TEST(Covariance, IsMadeOfStandardDeviationsAndCorrelationsAndTakenApartAgain) {
    Eigen::Matrix3d expected;
    expected << 1.0, 1.0, -1.0,  //
        1.0, 4.0, 0.8,           //
        -1.0, 0.8, 16.0;
    const Eigen::Matrix3d covariance = covariance_of(noise);
    EXPECT_TRUE(covariance.isApprox(1e-6 * expected, 1e-12)) << covariance;
    const PlaceNoise again = noise_of(covariance);
    EXPECT_TRUE(again.std_dev.isApprox(noise.std_dev, 1e-12));
    EXPECT_TRUE(again.correlations.isApprox(noise.correlations, 1e-12));
}

TEST(Covariance, OfAnExactCoordinateIsCorrelatedWithNothing) {
    const PlaceNoise plane = noise_of(Eigen::Vector3d(4.0, 0.0, 9.0).asDiagonal());
    EXPECT_EQ(plane.std_dev, Eigen::Vector3d(2.0, 0.0, 3.0));
    EXPECT_EQ(plane.correlations, Eigen::Vector3d::Zero());
}

TEST(Covariance, TimesItsWeightIsOneAndWhitenedIsOne) {
    const Eigen::Matrix3d covariance = covariance_of(noise);
    EXPECT_TRUE((covariance * weight_of(noise)).isIdentity(1e-12));
    const Eigen::Matrix3d whitening = whitening_of(noise);
    EXPECT_TRUE((whitening * covariance * whitening.transpose()).isIdentity(1e-12));
    const PlaceNoise alone{.std_dev = {1e-3, 2e-3, 4e-3}, .correlations = Eigen::Vector3d::Zero()};
    EXPECT_EQ(whitening_of(alone),
              Eigen::Matrix3d(Eigen::Vector3d(alone.std_dev.cwiseInverse()).asDiagonal()));
}

TEST(Covariance, HasCorrelationsWhoseMatrixIsPositiveDefinite) {
    EXPECT_TRUE(are_possible_correlations({0.0, 0.0, 0.0}));
    EXPECT_TRUE(are_possible_correlations({0.999, 0.9, 0.9}));
    EXPECT_FALSE(are_possible_correlations({1.0, 0.0, 0.0}));
    EXPECT_FALSE(are_possible_correlations({0.0, -1.5, 0.0}));
    // Each is possible, but not all together.
    EXPECT_FALSE(are_possible_correlations({0.9, 0.9, -0.9}));
    EXPECT_FALSE(are_possible_correlations({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}));
}

}  // namespace
}  // namespace taut
