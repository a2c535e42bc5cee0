// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against two points taken for one, and against digits lost in a mean.

#include "survey/repeated_points.hpp"

#include <gmock/gmock.h>

namespace taut {
namespace {

TEST(RepeatedPoints, AreAveragedWithoutLossFarFromTheOrigin) {
    const Eigen::Vector3d far(4.5e6, 5.4e6, 300.0);
    const std::vector<SurveyPoint> points{
        {.id = "A", .position = far, .line = 1, .noise_std = Eigen::Vector3d(3e-3, 3e-3, 6e-3)},
        {.id = "", .position = far, .line = 2},
        {.id = "A",
         .position = far + Eigen::Vector3d(0.0, 0.0, 0.004),
         .line = 3,
         .noise_std = Eigen::Vector3d(4e-3, 4e-3, 8e-3)}};
    const AveragedPoints averaged = average_repeated(points, 0.0);
    ASSERT_EQ(averaged.points.size(), 2U);
    EXPECT_NEAR(averaged.points[0].position.z(), 300.002, 1e-12);
    EXPECT_EQ(averaged.points[0].position.x(), far.x());
    EXPECT_NEAR(averaged.points[0].noise_std->x(), 2.5e-3, 1e-15);
    EXPECT_EQ(averaged.points[1].line, 2);
    EXPECT_THAT(averaged.note, testing::HasSubstr("1 point was measured several times"));
}

TEST(RepeatedPoints, HaveTheCovarianceOfTheirMean) {
    const Eigen::Vector3d std_dev(3e-3, 3e-3, 6e-3);
    const std::vector<SurveyPoint> points{{.id = "A",
                                           .position = {1, 2, 3},
                                           .noise_std = std_dev,
                                           .noise_correlations = {0.5, 0.0, -0.25}},
                                          {.id = "A",
                                           .position = {1, 2, 3},
                                           .noise_std = std_dev,
                                           .noise_correlations = {0.1, 0.0, 0.25}}};
    const SurveyPoint mean = average_repeated(points, 0.0).points.front();
    EXPECT_TRUE(mean.noise_std->isApprox(std_dev / std::sqrt(2.0), 1e-12));
    EXPECT_TRUE(mean.noise_correlations.isApprox(Eigen::Vector3d(0.3, 0.0, 0.0), 1e-12));
}

TEST(RepeatedPoints, AreLeftAloneWhereEachNameStandsOnce) {
    const AveragedPoints averaged = average_repeated(
        {{.id = "A", .position = {1, 2, 3}}, {.id = "B", .position = {1, 2, 3}}}, 0.0);
    EXPECT_EQ(averaged.points.size(), 2U);
    EXPECT_EQ(averaged.note, "");
}

TEST(RepeatedPoints, MayLieAsFarApartAsTheirNoiseExplains) {
    const std::vector<SurveyPoint> points{{.id = "A", .position = {0, 0, 0}, .line = 4},
                                          {.id = "A", .position = {0, 0, 0.1}, .line = 7}};
    EXPECT_EQ(average_repeated(points, 0.02).points.size(), 1U);
    try {
        static_cast<void>(average_repeated(points, 0.005));
        FAIL() << "expected a SurveyError";
    } catch (const SurveyError& error) {
        EXPECT_EQ(error.line(), 7);
        EXPECT_THAT(error.what(), testing::HasSubstr("100 mm from where line 4 has it, expected at "
                                                     "most 50 mm"));
    }
}

}  // namespace
}  // namespace taut
