// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against scales that are not the likeliest, by a wrong gradient, and against groups mixed
// up.
#include "gp/input_scales.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "gp/likelihood_profile.hpp"
#include "support/finite_differences.hpp"
#include "support/textbook.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

/// Depends on the first input strongly, on the second little, and not at all on the last two.
Eigen::MatrixXd outputs_of(const Eigen::MatrixXd& inputs) {
    Eigen::MatrixXd y = 1e-3 * normal_matrix(inputs.cols(), 3, 7);
    y.col(0) += (2.0 * inputs.row(0)).array().sin().matrix().transpose();
    y.col(1) += inputs.row(0).cwiseAbs2().transpose() + 0.1 * inputs.row(1).transpose();
    y.col(2) += (inputs.row(0) + 0.2 * inputs.row(1)).array().tanh().matrix().transpose();
    return y;
}

TEST(ScalesLikelihood, HasTheGradientOfItsDifferenceQuotient) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 40, 1);
    const Eigen::MatrixXd outputs = outputs_of(inputs);
    const std::vector<int> groups{0, 1, 2, 1};
    const Eigen::VectorXd at{{-0.3, -1.0, -2.0}};
    const Eigen::MatrixXd expected = test::finite_differences(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return Eigen::VectorXd::Constant(1,
                                             scales_likelihood(inputs, outputs, groups, x).value);
        },
        at, 1e-3);
    const Eigen::VectorXd gradient = scales_likelihood(inputs, outputs, groups, at).gradient;
    EXPECT_LT((gradient - expected.row(0).transpose()).cwiseAbs().maxCoeff(),
              1e-5 * expected.cwiseAbs().maxCoeff());
}

TEST(ScalesLikelihood, WithOneScaleIsThatOfTheIsotropicKernel) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 40, 1);
    const Eigen::MatrixXd outputs = outputs_of(inputs);
    const Eigen::MatrixXd squares = squared_distances(inputs, inputs);
    const LikelihoodProfile expected = profile_likelihood(
        kernel_spectrum(squares, 0.7), squares, outputs, default_noise_ratio_bounds(inputs.cols()));
    const ScalesLikelihood found = scales_likelihood(inputs, outputs, {0, 0, 0, 0},
                                                     Eigen::VectorXd::Constant(1, std::log(0.7)));
    EXPECT_NEAR(found.value, expected.value.sum(), 1e-8 * std::abs(found.value));
    EXPECT_NEAR(found.gradient(0), expected.slope.sum(), 1e-5 * std::abs(found.gradient(0)));
}

TEST(EstimateInputScales, FindsWhatMatters) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 120, 1);
    const Eigen::MatrixXd outputs = outputs_of(inputs);
    const Eigen::VectorXd scales = estimate_input_scales(inputs, outputs, {0, 1, 2, 3});
    EXPECT_NEAR(scales.array().log().mean(), 0.0, 1e-12);
    EXPECT_GT(scales(0), 2.0 * scales(1));
    EXPECT_GT(scales(1), 2.0 * scales(2));
    EXPECT_GT(scales(1), 2.0 * scales(3));

    // No less likely than one scale for all, whatever that is.
    const auto value = [&](const Eigen::VectorXd& at) {
        return scales_likelihood(inputs, outputs, {0, 1, 2, 3}, at).value;
    };
    double of_one_scale = std::numeric_limits<double>::infinity();
    double of_these = of_one_scale;
    for (double common = -5.0; common < 2.0; common += 0.25) {
        of_one_scale = std::min(of_one_scale, value(Eigen::VectorXd::Constant(4, common)));
        of_these = std::min(of_these, value(scales.array().log() + common));
    }
    EXPECT_LT(of_these, of_one_scale - 100.0);

    // And so predicts better where it was not trained.
    const Eigen::MatrixXd at = normal_matrix(4, 50, 9);
    const Eigen::MatrixXd truth = outputs_of(at);
    const auto error = [&](const Eigen::VectorXd& s) {
        return (fit(s.asDiagonal() * inputs, outputs)
                    .predict(s.asDiagonal() * at)
                    .mean.transpose() -
                truth)
            .squaredNorm();
    };
    EXPECT_LT(error(scales), 0.2 * error(Eigen::VectorXd::Ones(4)));
}

TEST(EstimateInputScales, GivesTheDimensionsOfAGroupOneScale) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 60, 1);
    const Eigen::VectorXd scales = estimate_input_scales(inputs, outputs_of(inputs), {1, 0, 0, 1});
    EXPECT_EQ(scales(0), scales(3));
    EXPECT_EQ(scales(1), scales(2));
    EXPECT_NE(scales(0), scales(1));
}

TEST(EstimateInputScales, OfOneGroupOrNothingToLearnAreAllOne) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 30, 1);
    EXPECT_EQ(estimate_input_scales(inputs, outputs_of(inputs), {0, 0, 0, 0}),
              Eigen::VectorXd::Ones(4));
    EXPECT_EQ(estimate_input_scales(inputs, Eigen::MatrixXd::Ones(30, 2), {0, 1, 2, 3}),
              Eigen::VectorXd::Ones(4));
}

TEST(EstimateInputScales, EndsWhereItIsGivenUp) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 30, 1);
    for (const int last : {2, 7}) {  // while it looks for a start, and afterwards
        std::vector<int> reported;
        const Progress progress{
            .report =
                [&](std::string_view stage, int done, int total) {
                    EXPECT_EQ(stage, "scales of the kernel");
                    EXPECT_LT(done, total);
                    reported.push_back(done);
                },
            .stop_requested = [&] { return static_cast<int>(reported.size()) == last; }};
        EXPECT_THROW(
            (void)estimate_input_scales(inputs, outputs_of(inputs), {0, 1, 2, 3}, progress),
            Interrupted);
        EXPECT_EQ(static_cast<int>(reported.size()), last);
        EXPECT_EQ(reported.back(), last - 1);
    }
}

TEST(EstimateInputScales, RefusesGroupsThatAreNotOneADimension) {
    const Eigen::MatrixXd inputs = normal_matrix(4, 30, 1);
    const Eigen::MatrixXd outputs = outputs_of(inputs);
    EXPECT_THROW((void)estimate_input_scales(inputs, outputs, {0, 1}), std::invalid_argument);
    for (const int group : {-1, 4, 2'000'000'000}) {
        EXPECT_THROW((void)estimate_input_scales(inputs, outputs, {0, 1, 2, group}),
                     std::invalid_argument);
    }
    EXPECT_THROW((void)estimate_input_scales(inputs, outputs.topRows(10), {0, 1, 2, 3}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace taut::gp
