// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against predictions that are not those of the formula, such as of another output's
// hyperparameters, and against a variance that is too small far from the training inputs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/finite_differences.hpp"
#include "support/textbook.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

/// Five outputs with smoothness and noise of their own.
Eigen::MatrixXd some_outputs(const Eigen::MatrixXd& inputs) {
    Eigen::MatrixXd y = normal_matrix(inputs.cols(), 5, 2) *
                        Eigen::VectorXd{{0.1, 0.02, 0.3, 0.1, 0.05}}.asDiagonal();
    y.col(0) += inputs.row(0).transpose();
    y.col(1) += (2.0 * inputs.row(1)).array().sin().matrix().transpose();
    y.col(2) += inputs.row(0).cwiseProduct(inputs.row(2)).transpose();
    y.col(3) += (inputs.row(1) + inputs.row(2)).array().tanh().matrix().transpose();
    y.col(4) += (3.0 * inputs.row(2)).array().cos().matrix().transpose();
    return y;
}

/// One process with given hyperparameters, conditioned on an output.
FittedProcesses conditioned(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& output,
                            const Hyperparameters& theta) {
    FittedProcesses result;
    result.inputs = inputs;
    result.spectra.push_back(
        kernel_spectrum(squared_distances(inputs, inputs), theta.inverse_length_scale));
    const KernelSpectrum& spectrum = result.spectra.front();
    const double ratio = std::pow(theta.noise_std / theta.signal_std, 2);
    result.weights =
        spectrum.eigenvectors * (spectrum.eigenvectors.transpose() * output)
                                    .cwiseQuotient((spectrum.eigenvalues.array() + ratio).matrix());
    result.processes.push_back({.hyperparameters = theta, .spectrum = 0});
    return result;
}

TEST(MeanGradient, IsTheDifferenceQuotientOfTheMean) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 50, 1);
    Eigen::MatrixXd outputs = some_outputs(inputs);
    outputs.col(2).setConstant(1.0);  // not fitted
    const FittedProcesses fitted = fit(inputs, outputs);
    ASSERT_GT(fitted.spectra.size(), 1);
    const Eigen::VectorXd at = normal_matrix(3, 1, 5);
    const Eigen::MatrixXd expected = test::finite_differences(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return fitted.predict(x).mean.col(0); },
        at, 1e-3);
    const Eigen::MatrixXd gradient = fitted.mean_gradient(at);
    EXPECT_LT((gradient - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
    EXPECT_EQ(gradient.row(2), Eigen::RowVector3d::Zero());
}

TEST(Predict, IsTheDenseFormulaForEveryOutputOfAFit) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 50, 1);
    const Eigen::MatrixXd outputs = some_outputs(inputs);
    const Eigen::MatrixXd at = 1.5 * normal_matrix(3, 20, 3);
    const FittedProcesses fitted = fit(inputs, outputs);
    ASSERT_GT(fitted.spectra.size(), 1);
    const Prediction prediction = fitted.predict(at);
    for (Eigen::Index j = 0; j < outputs.cols(); ++j) {
        const auto expected = test::textbook_prediction(inputs, outputs.col(j),
                                                        fitted.processes[j].hyperparameters, at);
        EXPECT_LT((prediction.mean.row(j).transpose() - expected.mean).cwiseAbs().maxCoeff(), 1e-7)
            << j;
        EXPECT_LT((prediction.std_dev.row(j).transpose() - expected.std_dev).cwiseAbs().maxCoeff(),
                  1e-7)
            << j;
    }
}

RC_GTEST_PROP(Predict, IsTheDenseFormulaForAnyHyperparameters, ()) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 30, 1);
    const Eigen::VectorXd output = some_outputs(inputs).col(2);
    const auto power_of_ten = [](int lower, int upper) {
        return std::pow(10.0, *rc::gen::inRange(100 * lower, 100 * upper) / 100.0);
    };
    const double signal = power_of_ten(-1, 3);
    const Hyperparameters theta{.inverse_length_scale = power_of_ten(-1, 1),
                                .signal_std = signal,
                                .noise_std = signal * power_of_ten(-2, 1)};
    const Eigen::MatrixXd at = normal_matrix(3, 5, *rc::gen::arbitrary<std::uint64_t>());
    const Prediction prediction = conditioned(inputs, output, theta).predict(at);
    const auto expected = test::textbook_prediction(inputs, output, theta, at);
    RC_ASSERT((prediction.mean.transpose() - expected.mean).cwiseAbs().maxCoeff() < 1e-8);
    RC_ASSERT((prediction.std_dev.transpose() - expected.std_dev).cwiseAbs().maxCoeff() <
              1e-8 * signal);
}

TEST(Predict, KnowsNothingFarFromTheTrainingInputs) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 50, 1);
    const FittedProcesses fitted = fit(inputs, some_outputs(inputs));
    const Prediction prediction = fitted.predict(Eigen::Vector3d::Constant(1e6));
    for (Eigen::Index j = 0; j < prediction.mean.rows(); ++j) {
        EXPECT_NEAR(prediction.mean(j, 0), 0.0, 1e-300);
        EXPECT_DOUBLE_EQ(prediction.std_dev(j, 0), fitted.processes[j].hyperparameters.signal_std);
    }
}

TEST(Predict, OfNoInputsIsEmptyAndRefusesBadOnes) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 20, 1);
    const FittedProcesses fitted = fit(inputs, some_outputs(inputs));
    const Prediction prediction = fitted.predict(Eigen::MatrixXd(3, 0));
    EXPECT_EQ(prediction.mean.rows(), 5);
    EXPECT_EQ(prediction.mean.cols(), 0);
    EXPECT_EQ(prediction.std_dev.cols(), 0);
    EXPECT_THROW((void)fitted.predict(normal_matrix(2, 4, 1)), std::invalid_argument);
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Eigen::MatrixXd at = normal_matrix(3, 4, 1);
        at(2, 1) = value;
        EXPECT_THROW((void)fitted.predict(at), std::invalid_argument);
    }
}

}  // namespace
}  // namespace taut::gp
