// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against processes of low rank that are surer than exact ones, that err by more than they
// report, or that learn less than they could.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "support/textbook.hpp"
#include "taut/gp/fit.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

constexpr Eigen::Index n = 400;

/// Outputs of some roughness each, with noise: 0.02 of their size.
Eigen::MatrixXd some_outputs(const Eigen::MatrixXd& inputs) {
    Eigen::MatrixXd y = 0.02 * normal_matrix(inputs.cols(), 4, 2);
    y.col(0) += inputs.row(0).transpose();
    y.col(1) += inputs.row(0).cwiseProduct(inputs.row(1)).transpose();
    y.col(2) += (1.5 * inputs.row(1)).array().sin().matrix().transpose();
    y.col(3) += (inputs.row(0) + inputs.row(2)).array().tanh().matrix().transpose();
    return y;
}

FitSettings low_rank(int most_decomposed, int rank) {
    // The textbook's factorisation loses its digits where there is hardly any noise.
    return {.noise_ratio = NoiseRatioBounds{.lower = 1e-6},
            .most_decomposed = most_decomposed,
            .rank = rank};
}

/// Root mean square, by the inverse of the covariance (Rasmussen and Williams, eq. 5.12).
double textbook_leave_one_out(const Eigen::MatrixXd& inputs, const Eigen::VectorXd& output,
                              const Process& process) {
    const Eigen::MatrixXd inverse = test::textbook_covariance(inputs, process.hyperparameters)
                                        .solve(Eigen::MatrixXd::Identity(n, n));
    const Eigen::ArrayXd errors = (inverse * output).array() / inverse.diagonal().array();
    return std::sqrt(errors.square().mean());
}

class LowRank : public testing::Test {
protected:
    Eigen::MatrixXd m_inputs = normal_matrix(3, n, 1);
    Eigen::MatrixXd m_outputs = some_outputs(m_inputs);
    Eigen::MatrixXd m_at = 1.2 * normal_matrix(3, 60, 3);
};

TEST_F(LowRank, IsChosenBeyondTheInputsThatAreDecomposed) {
    EXPECT_EQ(fit(m_inputs, m_outputs, low_rank(n, 50)).rank(), std::nullopt);
    EXPECT_EQ(fit(m_inputs, m_outputs, low_rank(n - 1, 50)).rank(), 50);
}

TEST_F(LowRank, PredictsNearlyAsTheExactOne) {
    const FittedProcesses exact = fit(m_inputs, m_outputs, low_rank(n, 1));
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 100));
    const Eigen::MatrixXd truth = some_outputs(m_at).transpose();  // with noise of its own
    const Prediction expected = exact.predict(m_at);
    const Prediction found = fitted.predict(m_at);
    for (Eigen::Index j = 0; j < m_outputs.cols(); ++j) {
        SCOPED_TRACE(j);
        EXPECT_NEAR(std::log(fitted.processes[j].hyperparameters.noise_std /
                             exact.processes[j].hyperparameters.noise_std),
                    0.0, 0.2);
        // Four outputs share three lambdas, so not each has its best.
        EXPECT_LT((found.mean - truth).row(j).squaredNorm(),
                  1.25 * (expected.mean - truth).row(j).squaredNorm());
    }
}

TEST_F(LowRank, HasAboutTheLeaveOneOutErrorOfTheExactOneOfItsHyperparameters) {
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 200));
    for (Eigen::Index j = 0; j < m_outputs.cols(); ++j) {
        const Process& process = fitted.processes[j];
        const double expected = textbook_leave_one_out(m_inputs, m_outputs.col(j), process);
        EXPECT_NEAR(process.leave_one_out_rmse, expected, 0.05 * expected) << j;
    }
}

TEST_F(LowRank, IsNeverSurerThanTheExactOneOfItsHyperparameters) {
    for (const int rank : {5, 20, 100}) {
        const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, rank));
        const Prediction found = fitted.predict(m_at);
        for (Eigen::Index j = 0; j < m_outputs.cols(); ++j) {
            const auto exact = test::textbook_prediction(m_inputs, m_outputs.col(j),
                                                         fitted.processes[j].hyperparameters, m_at);
            const Eigen::VectorXd surer = exact.std_dev - found.std_dev.row(j).transpose();
            EXPECT_LT(surer.maxCoeff(), 1e-7) << rank << ' ' << j;
        }
    }
}

TEST_F(LowRank, IsNotSureOfWhatItDoesNotKnowWhereThereIsNoNoise) {
    const auto truth = [](const Eigen::MatrixXd& at) -> Eigen::MatrixXd {
        return (5.0 * at.row(0)).array().sin().matrix().transpose();
    };
    const Eigen::MatrixXd inputs = normal_matrix(1, 1200, 1).array().tanh();
    const Eigen::MatrixXd at = normal_matrix(1, 100, 2).array().tanh();
    FitSettings settings = low_rank(600, 300);
    settings.noise_ratio.reset();
    const Prediction found = fit(inputs, truth(inputs), settings).predict(at);
    const Eigen::VectorXd off = (found.mean.transpose() - truth(at)).cwiseAbs();
    EXPECT_LT(off.cwiseQuotient(found.std_dev.transpose()).maxCoeff(), 5.0);
    EXPECT_LT(found.std_dev.maxCoeff(), 1e-5);
}

/// Inputs in pairs, each far from all others, and the directions of their correlation.
FittedProcesses pairs_of_inputs(double eigenvalue) {
    constexpr Eigen::Index pairs = 20;
    FittedProcesses fitted{.inputs = Eigen::MatrixXd(1, 2 * pairs),
                           .spectra = {},
                           .processes = {{.hyperparameters = {.inverse_length_scale = 1.0,
                                                              .signal_std = 2.0,
                                                              .noise_std = 2e-9},
                                          .spectrum = 0}},
                           .weights = Eigen::MatrixXd::Zero(2 * pairs, 1)};
    KernelSpectrum spectrum{.inverse_length_scale = 1.0,
                            .eigenvalues = Eigen::VectorXd::Constant(pairs, eigenvalue),
                            .eigenvectors = Eigen::MatrixXd::Zero(2 * pairs, pairs)};
    spectrum.tail_largest = 1e-18;
    for (Eigen::Index i = 0; i < pairs; ++i) {
        fitted.inputs.middleCols(2 * i, 2).setConstant(100.0 * static_cast<double>(i));
        spectrum.eigenvectors.col(i).segment(2 * i, 2).setConstant(std::sqrt(0.5));
    }
    fitted.spectra.push_back(std::move(spectrum));
    return fitted;
}

TEST(LowRankVariance, IsNotThatOfThePriorWhereRoundingMakesItNegative) {
    const FittedProcesses fitted = pairs_of_inputs(2.0);
    EXPECT_LT(fitted.predict(fitted.inputs).std_dev.maxCoeff(), 1e-3);
}

TEST(LowRankVariance, IsThatOfThePriorWhereDirectionsExplainMoreThanThereIs) {
    const FittedProcesses fitted = pairs_of_inputs(1.9);
    EXPECT_EQ(fitted.predict(fitted.inputs).std_dev.minCoeff(), 2.0);
}

TEST_F(LowRank, HasTheLeaveOneOutErrorOfInputsThatStandAlone) {
    // One of twenty far out, where most are not among those that the directions come from.
    for (Eigen::Index i = 0; i < n; ++i) {
        m_inputs.col(i) *= i % 20 == 7 ? 50.0 : 0.01;
    }
    const Eigen::ArrayXd wave = (100.0 * m_inputs.row(0)).array().sin();
    const Eigen::ArrayXd envelope = (-m_inputs.colwise().squaredNorm()).array().exp();
    m_outputs = wave * envelope + 0.01 * m_inputs.row(1).transpose().array();
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 100));
    for (Eigen::Index j = 0; j < m_outputs.cols(); ++j) {
        const Process& process = fitted.processes[j];
        const double expected = textbook_leave_one_out(m_inputs, m_outputs.col(j), process);
        EXPECT_GT(process.leave_one_out_rmse, 0.98 * expected) << j;
    }
}

TEST_F(LowRank, TakesInputsOfWhichManyAreTheSame) {
    for (Eigen::Index i = 0; i < n; i += 2) {
        m_inputs.col(i).setConstant(0.1);
    }
    m_outputs = some_outputs(m_inputs);
    for (const Process& process : fit(m_inputs, m_outputs, low_rank(200, 100)).processes) {
        EXPECT_LT(process.leave_one_out_rmse, 0.1);
    }
    m_inputs.rightCols(n - 6).setConstant(0.1);
    m_inputs.col(200) = Eigen::Vector3d::Ones();
    const Prediction found = fit(m_inputs, some_outputs(m_inputs), low_rank(200, 50)).predict(m_at);
    EXPECT_TRUE(found.mean.allFinite());
    EXPECT_TRUE(found.std_dev.allFinite());
}

TEST_F(LowRank, IsNoFurtherOffTheExactOneOfItsHyperparametersThanItReports) {
    for (const int rank : {5, 20, 100}) {
        const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, rank));
        const Prediction found = fitted.predict(m_inputs);
        for (Eigen::Index j = 0; j < m_outputs.cols(); ++j) {
            const Process& process = fitted.processes[j];
            const auto exact = test::textbook_prediction(m_inputs, m_outputs.col(j),
                                                         process.hyperparameters, m_inputs);
            const double off =
                std::sqrt((found.mean.row(j).transpose() - exact.mean).cwiseAbs2().mean());
            EXPECT_LE(off, process.approximation_error + 1e-8) << rank << ' ' << j;
            EXPECT_GT(process.approximation_error, 0.0);
        }
    }
}

TEST_F(LowRank, HasNoLessNoiseThanItLeavesOut) {
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 20));
    for (const Process& process : fitted.processes) {
        const auto& [lambda, signal, noise] = process.hyperparameters;
        EXPECT_GE(std::pow(noise / signal, 2), 0.999 * fitted.spectra[process.spectrum].tail_mean);
    }
}

TEST_F(LowRank, ReportsHowMuchItLeavesOut) {
    EXPECT_EQ(fit(m_inputs, m_outputs, low_rank(n, 1)).left_out(), 0.0);
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 1));
    double expected = 0.0;
    for (const KernelSpectrum& spectrum : fitted.spectra) {
        expected = std::max(expected, 1.0 - spectrum.eigenvalues.sum() / n);
    }
    EXPECT_NEAR(fitted.left_out(), expected, 1e-12);
    EXPECT_GT(expected, 1e-3);
}

TEST_F(LowRank, MarksAConstantOutputAndTakesOneThatIsConstantOnAPart) {
    m_outputs.col(1).setConstant(0.3);
    m_outputs.col(2).setZero();
    m_outputs(1, 2) = 1.0;  // of 200 inputs evenly spread over 400 it is none
    const FittedProcesses fitted = fit(m_inputs, m_outputs, low_rank(200, 50));
    EXPECT_EQ(fitted.processes[0].status, FitStatus::fitted);
    EXPECT_EQ(fitted.processes[1].status, FitStatus::constant_output);
    EXPECT_EQ(fitted.processes[2].status, FitStatus::fitted);
    EXPECT_TRUE(fitted.predict(m_at).mean.allFinite());
    m_outputs(Eigen::all, {0, 3}) = m_outputs(Eigen::all, {2, 2}).eval();
    EXPECT_TRUE(fit(m_inputs, m_outputs, low_rank(200, 50)).predict(m_at).std_dev.allFinite());
}

TEST_F(LowRank, GivesUpWhereAStopIsRequestedAfterTheSearch) {
    std::atomic<bool> is_by_low_rank = false;
    const Progress progress{.report = [&](std::string_view, int done,
                                          int total) { is_by_low_rank = 2 * done >= total; },
                            .stop_requested = [&] { return is_by_low_rank.load(); }};
    EXPECT_THROW((void)fit(m_inputs, m_outputs, low_rank(200, 50), progress), Interrupted);
}

TEST_F(LowRank, RefusesSettingsOutOfRange) {
    EXPECT_THROW((void)fit(m_inputs, m_outputs, low_rank(1, 50)), std::invalid_argument);
    EXPECT_THROW((void)fit(m_inputs, m_outputs, low_rank(200, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace taut::gp
