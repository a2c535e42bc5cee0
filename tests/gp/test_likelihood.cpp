// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a likelihood or a slope that is not that of the formula, and against a profile
// that stops in the wrong one of two valleys over the noise ratio: training would then end at
// hyperparameters that are not the best, and nothing else would show it.
#include "taut/gp/likelihood.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "gp/likelihood_profile.hpp"
#include "support/textbook.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

/// Smooth functions of three inputs with noise: a column each.
struct Data {
    Eigen::MatrixXd inputs = normal_matrix(3, 30, 1);
    Eigen::MatrixXd distances = squared_distances(inputs, inputs);
    Eigen::MatrixXd outputs = noisy_outputs(inputs);

    static Eigen::MatrixXd noisy_outputs(const Eigen::MatrixXd& x) {
        Eigen::MatrixXd y = 0.1 * normal_matrix(x.cols(), 3, 2);
        y.col(0) += x.row(0).transpose();
        y.col(1) += (2.0 * x.row(1) + x.row(2)).array().sin().matrix().transpose();
        y.col(2) += 20.0 * x.row(0).cwiseProduct(x.row(2)).transpose();
        return y;
    }
};

double value_at(const Data& data, Eigen::Index output, const Eigen::Vector3d& log_theta) {
    const Hyperparameters theta{.inverse_length_scale = std::exp(log_theta(0)),
                                .signal_std = std::exp(log_theta(1)),
                                .noise_std = std::exp(log_theta(2))};
    return negative_log_likelihood(kernel_spectrum(data.distances, theta.inverse_length_scale),
                                   data.distances, data.outputs.col(output), theta)
        .value;
}

/// Between 10^lower and 10^upper, evenly in the logarithm.
double log_uniform(double lower, double upper) {
    return std::pow(10.0, lower + (upper - lower) * *rc::gen::inRange(0, 10001) / 1e4);
}

/// Hyperparameters whose covariance is well conditioned.
Hyperparameters some_hyperparameters() {
    const double signal = log_uniform(-1.0, 2.0);
    return {.inverse_length_scale = log_uniform(-1.0, 1.0),
            .signal_std = signal,
            .noise_std = signal * log_uniform(-2.0, 1.0)};
}

RC_GTEST_PROP(NegativeLogLikelihood, IsThatOfTheDenseFormula, ()) {
    const Data data;
    const Hyperparameters theta = some_hyperparameters();
    const auto j = *rc::gen::inRange<Eigen::Index>(0, 3);
    const double value =
        negative_log_likelihood(kernel_spectrum(data.distances, theta.inverse_length_scale),
                                data.distances, data.outputs.col(j), theta)
            .value;
    const double expected =
        test::textbook_negative_log_likelihood(data.inputs, data.outputs.col(j), theta);
    RC_ASSERT(std::abs(value - expected) < 1e-9 * (1.0 + std::abs(expected)));
}

RC_GTEST_PROP(NegativeLogLikelihood, HasTheGradientOfItsFiniteDifferences, ()) {
    const Data data;
    const Hyperparameters theta = some_hyperparameters();
    const auto j = *rc::gen::inRange<Eigen::Index>(0, 3);
    const Eigen::Vector3d gradient =
        negative_log_likelihood(kernel_spectrum(data.distances, theta.inverse_length_scale),
                                data.distances, data.outputs.col(j), theta)
            .gradient;
    const Eigen::Vector3d at(std::log(theta.inverse_length_scale), std::log(theta.signal_std),
                             std::log(theta.noise_std));
    const double scale = 1.0 + std::abs(value_at(data, j, at));
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(i);
        const double difference =
            (value_at(data, j, at + step) - value_at(data, j, at - step)) / 2e-5;
        RC_ASSERT(std::abs(gradient(i) - difference) < 1e-6 * scale);
    }
}

RC_GTEST_PROP(ProfileLikelihood, IsTheLikelihoodAtTheHyperparametersItNames, ()) {
    const Data data;
    const KernelSpectrum spectrum = kernel_spectrum(data.distances, log_uniform(-1.0, 1.0));
    const LikelihoodProfile profile =
        profile_likelihood(spectrum, data.distances, data.outputs, {.lower = 1e-4});
    for (Eigen::Index j = 0; j < data.outputs.cols(); ++j) {
        const double variance = profile.signal_variance(j);
        const Likelihood likelihood =
            negative_log_likelihood(spectrum, data.distances, data.outputs.col(j),
                                    {.inverse_length_scale = spectrum.inverse_length_scale,
                                     .signal_std = std::sqrt(variance),
                                     .noise_std = std::sqrt(variance * profile.noise_ratio(j))});
        RC_ASSERT(std::abs(profile.value(j) - likelihood.value) <
                  1e-10 * (1.0 + std::abs(likelihood.value)));
        // By the envelope theorem.
        RC_ASSERT(std::abs(profile.slope(j) - likelihood.gradient(0)) <
                  1e-8 * (1.0 + std::abs(likelihood.gradient(0))));
    }
}

RC_GTEST_PROP(ProfileLikelihood, IsNowhereBeatenWithinTheBounds, ()) {
    const Data data;
    const NoiseRatioBounds bounds = default_noise_ratio_bounds(data.inputs.cols());
    const KernelSpectrum spectrum = kernel_spectrum(data.distances, log_uniform(-3.0, 1.0));
    const LikelihoodProfile profile =
        profile_likelihood(spectrum, data.distances, data.outputs, bounds);
    const double ratio = log_uniform(std::log10(bounds.lower), std::log10(bounds.upper));
    for (Eigen::Index j = 0; j < data.outputs.cols(); ++j) {
        RC_ASSERT(profile.noise_ratio(j) >= bounds.lower * (1.0 - 1e-12));
        RC_ASSERT(profile.noise_ratio(j) <= bounds.upper * (1.0 + 1e-12));
        const double variance = profile.signal_variance(j) * log_uniform(-6.0, 6.0);
        const double value =
            negative_log_likelihood(spectrum, data.distances, data.outputs.col(j),
                                    {.inverse_length_scale = spectrum.inverse_length_scale,
                                     .signal_std = std::sqrt(variance),
                                     .noise_std = std::sqrt(variance * ratio)})
                .value;
        RC_ASSERT(profile.value(j) <= value + 1e-9 * (1.0 + std::abs(value)));
    }
}

/// The profile's value at one noise ratio, for eigenvectors that are unit vectors.
double value_at_ratio(const Eigen::VectorXd& eigenvalues, const Eigen::VectorXd& y, double ratio) {
    const Eigen::ArrayXd d = eigenvalues.array() + ratio;
    const auto n = static_cast<double>(y.size());
    return 0.5 * (n * std::log((y.array().square() / d).mean()) + d.log().sum() +
                  n * (1.0 + std::log(2.0 * std::numbers::pi)));
}

RC_GTEST_PROP(ProfileLikelihood, FindsTheLowestOfSeveralValleysOfTheNoiseRatio, ()) {
    const auto n = *rc::gen::inRange<Eigen::Index>(2, 40);
    KernelSpectrum spectrum{.inverse_length_scale = 1.0,
                            .eigenvalues = Eigen::VectorXd(n),
                            .eigenvectors = Eigen::MatrixXd::Identity(n, n)};
    Eigen::VectorXd y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        spectrum.eigenvalues(i) = log_uniform(-14.0, 2.0);
        y(i) = log_uniform(-8.0, 1.0);
    }
    const NoiseRatioBounds bounds = default_noise_ratio_bounds(n);
    const double found =
        profile_likelihood(spectrum, Eigen::MatrixXd::Zero(n, n), y, bounds).value(0);
    double lowest = std::numeric_limits<double>::infinity();
    constexpr int steps = 3000;
    for (int k = 0; k <= steps; ++k) {
        const double ratio =
            bounds.lower * std::pow(bounds.upper / bounds.lower, static_cast<double>(k) / steps);
        lowest = std::min(lowest, value_at_ratio(spectrum.eigenvalues, y, ratio));
    }
    RC_ASSERT(found <= lowest + 1e-9 * (1.0 + std::abs(lowest)));
}

TEST(ProfileLikelihood, FindsANarrowValleyBesideOneAtTheLowerBound) {
    // At the ends of the range, the output looks like signal and like noise; in between lies a
    // valley that a step of 3 in log eta does not see.
    constexpr Eigen::Index n = 20;
    KernelSpectrum spectrum{.inverse_length_scale = 1.0,
                            .eigenvalues = Eigen::VectorXd::Constant(n, 1.0),
                            .eigenvectors = Eigen::MatrixXd::Identity(n, n)};
    spectrum.eigenvalues.head(18).setConstant(1e-9);
    Eigen::VectorXd y = Eigen::VectorXd::Constant(n, 1.0);
    y.head(18).setConstant(1e-2);
    const LikelihoodProfile profile = profile_likelihood(spectrum, Eigen::MatrixXd::Zero(n, n), y,
                                                         {.lower = 1e-13, .upper = 1e3});
    // Signal variance 1 and noise variance 1e-4 explain every entry: (d + eta) sigma_f^2 = y^2.
    EXPECT_NEAR(profile.noise_ratio(0), 1e-4, 1e-6);
    EXPECT_NEAR(profile.signal_variance(0), 1.0, 1e-3);
}

TEST(ProfileLikelihood, OfALowRankIsThatOfTheMatrixThatItStandsFor) {
    const Data data;
    const KernelSpectrum whole = kernel_spectrum(data.distances, 0.5);
    constexpr Eigen::Index rank = 12;
    const KernelSpectrum part{.inverse_length_scale = 0.5,
                              .eigenvalues = whole.eigenvalues.tail(rank),
                              .eigenvectors = whole.eigenvectors.rightCols(rank),
                              .tail_mean = 1e-3,
                              .tail_largest = 2e-3};
    KernelSpectrum filled = whole;
    filled.eigenvalues.head(30 - rank).setConstant(part.tail_mean);
    const NoiseRatioBounds bounds = default_noise_ratio_bounds(30);
    const LikelihoodProfile found = profile_likelihood(part, data.distances, data.outputs, bounds);
    const LikelihoodProfile expected =
        profile_likelihood(filled, data.distances, data.outputs, bounds);
    EXPECT_TRUE(found.value.isApprox(expected.value, 1e-9));
    EXPECT_TRUE(found.noise_ratio.isApprox(expected.noise_ratio, 1e-4));
    EXPECT_TRUE(found.signal_variance.isApprox(expected.signal_variance, 1e-4));
    EXPECT_EQ(found.slope.size(), 0);
}

TEST(NoiseRatioBounds, StayAboveTheRoundingErrorOfAnEigenvalue) {
    EXPECT_DOUBLE_EQ(default_noise_ratio_bounds(950).lower,
                     9500.0 * std::numeric_limits<double>::epsilon());
    EXPECT_GT(default_noise_ratio_bounds(0).lower, 0.0);
}

}  // namespace
}  // namespace taut::gp
