// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a rounded form that counts as exact, and an exact one that counts as rounded.

#include "survey/rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace taut {
namespace {

std::vector<SurveyPoint> points_to(double step, double offset = 0.0, int count = 100) {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> numbers(-5.0, 5.0);
    std::vector<SurveyPoint> points;
    for (int i = 0; i < count; ++i) {
        SurveyPoint point;
        for (double& x : point.position) {
            x = offset + numbers(engine);
            // By the inverse, as a reader of decimals finds the nearest double.
            x = step > 0.0 ? std::round(x / step) / std::round(1.0 / step) : x;
        }
        points.push_back(point);
    }
    return points;
}

TEST(Rounding, IsFoundByTheDigits) {
    for (const double step : {0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        EXPECT_NEAR(rounding_step(points_to(step), 1.0), step, 1e-9 * step);
        EXPECT_NEAR(rounding_step(points_to(step), 0.001), step < 1e-4 ? 0.0 : 1e-3 * step,
                    1e-9 * step);
        EXPECT_NEAR(rounding_step(points_to(step, 5.4e6), 1.0), step, 1e-9 * step);
    }
    EXPECT_DOUBLE_EQ(rounding_step(points_to(1.0), 0.001), 0.001);
}

TEST(Rounding, OfNumbersToTheLastDigitIsNone) {
    for (const double offset : {0.0, 1e3, 5.4e6, 1e9}) {
        EXPECT_EQ(rounding_step(points_to(0.0, offset), 1.0), 0.0) << offset;
        EXPECT_EQ(rounding_step(points_to(0.0, offset), 0.001), 0.0) << offset;
    }
    EXPECT_EQ(rounding_step(points_to(1e-9), 1.0), 0.0);
    EXPECT_EQ(rounding_step({}, 1.0), 0.0);
}

TEST(Rounding, IsThatOfMostNumbers) {
    std::vector<SurveyPoint> points = points_to(1e-4);
    points[0].position.x() = 1.0 / 3.0;
    points[1].position.y() = 0.1 + 0.2;
    EXPECT_NEAR(rounding_step(points, 1.0), 1e-4, 1e-12);
    // Round supports beside targets that are exact.
    points = points_to(0.0);
    for (size_t i = 0; i < 70; ++i) {
        points[i].position = points[i].position.array().round();
    }
    EXPECT_EQ(rounding_step(points, 1.0), 0.0);
}

TEST(Rounding, HasTheStandardDeviationOfAUniformPrior) {
    const auto points = points_to(0.0, 0.0, 20000);
    double squares = 0.0;
    for (const SurveyPoint& point : points) {
        const Eigen::Vector3d rounded = (point.position.array() * 1e3).round() * 1e-3;
        squares += (rounded - point.position).squaredNorm();
    }
    EXPECT_NEAR(rounding_std(1e-3), std::sqrt(squares / (3.0 * 20000)), 0.01 * 1e-3);
}

TEST(Rounding, AddsToNoiseThatIsNotFarAboveIt) {
    EXPECT_DOUBLE_EQ(noise_with_rounding(3e-4, 4e-4), 5e-4);
    EXPECT_EQ(noise_with_rounding(1e-3, 0.3e-3), 1e-3);
    EXPECT_EQ(noise_with_rounding(0.0, 0.3e-3), 0.0);
}

}  // namespace
}  // namespace taut
