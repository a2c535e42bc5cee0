// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against suggested targets that give no information, and against wrong gains.
#include "adjustment/survey_gain.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "support/textbook.hpp"

namespace taut {
namespace {

using test::normal_matrix;

/// For linear functions of coordinates the remaining variance is that of the conditional normal
/// distribution with the samples' covariance.
TEST(SurveyGain, IsThatOfTheConditionalDistribution) {
    constexpr int places = 5;
    constexpr double noise = 0.4;
    const Eigen::MatrixXd forms =
        normal_matrix(3 * places, 3 * places, 1) * normal_matrix(3 * places, 400, 2);
    const Eigen::MatrixXd numbers = normal_matrix(4, 3 * places, 3) * forms;
    const std::vector<SurveyGain> gains = gains_of_targets(forms, numbers, noise, 2);
    ASSERT_EQ(gains.size(), 2U);
    const Eigen::MatrixXd y = forms.colwise() - forms.rowwise().mean();
    const Eigen::MatrixXd x = numbers.colwise() - numbers.rowwise().mean();
    const auto remaining = [&](const std::vector<int>& seen) {
        std::vector<int> rows;
        for (const int s : seen) {
            rows.insert(rows.end(), {3 * s, 3 * s + 1, 3 * s + 2});
        }
        const double count = 399.0;
        const Eigen::MatrixXd at = y(rows, Eigen::all);
        Eigen::MatrixXd variance = at * at.transpose() / count;
        variance.diagonal().array() += noise * noise;
        const Eigen::MatrixXd shared = x * at.transpose() / count;
        const Eigen::MatrixXd left =
            x * x.transpose() / count - shared * variance.inverse() * shared.transpose();
        return std::sqrt(left.trace() / 4.0);
    };
    for (int s = 0; s < places; ++s) {
        EXPECT_LE(gains[0].remaining_std, remaining({s}) + 1e-9);
    }
    EXPECT_NEAR(gains[0].remaining_std, remaining({gains[0].place}), 1e-8);
    EXPECT_NEAR(gains[1].remaining_std, remaining({gains[0].place, gains[1].place}), 1e-8);
}

TEST(SurveyGain, IsNoneWhereTargetsGiveNoInformation) {
    EXPECT_TRUE(
        gains_of_targets(normal_matrix(60, 200, 4), normal_matrix(20, 200, 5), 0.5, 5).empty());
    EXPECT_TRUE(gains_of_targets(normal_matrix(60, 1, 4), normal_matrix(20, 1, 5), 0.5, 5).empty());
}

}  // namespace
}  // namespace taut
