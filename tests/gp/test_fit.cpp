// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against training that ends at hyperparameters worse than the best, in a wrong
// leave-one-out error, and in one output that cannot be learnt taking the others with it.
#include "support/not_finite.hpp"
#include "taut/gp/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "reference.hpp"
#include "support/refusals.hpp"
#include "support/textbook.hpp"

namespace taut::gp {
namespace {

using test::expect_refused;
using test::infinity;
using test::nan;
using test::normal_matrix;

/// A smooth function of some inputs (d x n) with noise.
Eigen::VectorXd smooth_output(const Eigen::MatrixXd& inputs, double noise, std::uint64_t seed) {
    const Eigen::VectorXd direction = normal_matrix(inputs.rows(), 1, seed).normalized();
    const Eigen::ArrayXd t = inputs.transpose() * direction;
    return (1.5 * t).sin() + 0.3 * t.square() +
           noise * normal_matrix(t.size(), 1, seed + 1).array();
}

void expect_finite(const FittedProcesses& fitted) {
    for (const Process& process : fitted.processes) {
        EXPECT_EQ(process.status, FitStatus::fitted);
        EXPECT_TRUE(std::isfinite(process.negative_log_likelihood));
        EXPECT_TRUE(std::isfinite(process.leave_one_out_rmse));
        EXPECT_TRUE(std::isfinite(process.hyperparameters.inverse_length_scale));
        EXPECT_GT(process.hyperparameters.signal_std, 0.0);
        EXPECT_TRUE(std::isfinite(process.hyperparameters.signal_std));
        EXPECT_GT(process.hyperparameters.noise_std, 0.0);
        EXPECT_TRUE(std::isfinite(process.hyperparameters.noise_std));
    }
    EXPECT_TRUE(fitted.weights.allFinite());
}

void expect_same(const Process& a, const Process& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.hyperparameters.inverse_length_scale, b.hyperparameters.inverse_length_scale);
    EXPECT_EQ(a.hyperparameters.signal_std, b.hyperparameters.signal_std);
    EXPECT_EQ(a.hyperparameters.noise_std, b.hyperparameters.noise_std);
    EXPECT_EQ(a.negative_log_likelihood, b.negative_log_likelihood);
    EXPECT_EQ(a.leave_one_out_rmse, b.leave_one_out_rmse);
    EXPECT_EQ(a.spectrum, b.spectrum);
}

/// Not worse than scikit-learn's best of many starts by more than 1e-6 of its likelihood.
void expect_as_likely(const Process& process, const test::ReferenceProcess& reference) {
    EXPECT_LE(process.negative_log_likelihood - reference.negative_log_likelihood,
              1e-6 * std::abs(reference.negative_log_likelihood));
}

TEST(Fit, IsAsLikelyAsScikitLearnForAllOutputsTogether) {
    for (const auto& data : test::reference_data()) {
        const FittedProcesses fitted = fit(data.inputs, data.outputs, {.max_spectra = 40});
        for (size_t j = 0; j < data.processes.size(); ++j) {
            SCOPED_TRACE(data.name + ", output " + std::to_string(j));
            expect_as_likely(fitted.processes[j], data.processes[j]);
        }
    }
}

TEST(Fit, IsThatOfScikitLearnInWhatTheLikelihoodDetermines) {
    for (const auto& data : test::reference_data()) {
        for (size_t j = 0; j < data.processes.size(); ++j) {
            SCOPED_TRACE(data.name + ", output " + std::to_string(j));
            const auto& reference = data.processes[j];
            const FittedProcesses fitted =
                fit(data.inputs, data.outputs.col(static_cast<Eigen::Index>(j)));
            const Hyperparameters& ours = fitted.processes.front().hyperparameters;
            const Hyperparameters& theirs = reference.hyperparameters;
            expect_as_likely(fitted.processes.front(), reference);
            const Prediction prediction = fitted.predict(data.test_inputs);
            const double noise_share = theirs.noise_std / theirs.signal_std;
            // Where noise explains all, any long length scale is as good; where there is none, any
            // small noise.
            if (noise_share < 1.0) {
                EXPECT_NEAR(std::log(ours.inverse_length_scale / theirs.inverse_length_scale), 0.0,
                            0.01);
                EXPECT_NEAR(std::log(ours.signal_std / theirs.signal_std), 0.0, 0.02);
            }
            if (noise_share > 1e-5) {
                EXPECT_NEAR(std::log(ours.noise_std / theirs.noise_std), 0.0, 0.01);
            }
            for (Eigen::Index k = 0; k < reference.mean.size(); ++k) {
                EXPECT_NEAR(prediction.mean(0, k), reference.mean(k), 0.02 * reference.std_dev(k));
                EXPECT_NEAR(prediction.std_dev(0, k), reference.std_dev(k),
                            0.02 * reference.std_dev(k));
            }
        }
    }
}

TEST(Fit, ReportsTheLikelihoodOfTheHyperparametersItReports) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    const Eigen::VectorXd output = smooth_output(inputs, 0.1, 2);
    const Process process = fit(inputs, output).processes.front();
    EXPECT_NEAR(process.negative_log_likelihood,
                test::textbook_negative_log_likelihood(inputs, output, process.hyperparameters),
                1e-8);
}

TEST(Fit, ReportsTheLeaveOneOutErrorOfAsManyRefits) {
    constexpr Eigen::Index n = 25;
    const Eigen::MatrixXd inputs = normal_matrix(2, n, 1);
    const Eigen::VectorXd output = smooth_output(inputs, 0.1, 2);
    const Process process = fit(inputs, output).processes.front();
    double sum = 0.0;
    for (Eigen::Index left_out = 0; left_out < n; ++left_out) {
        std::vector<Eigen::Index> others;
        for (Eigen::Index i = 0; i < n; ++i) {
            if (i != left_out) {
                others.push_back(i);
            }
        }
        const auto refit = test::textbook_prediction(inputs(Eigen::all, others), output(others),
                                                     process.hyperparameters, inputs.col(left_out));
        sum += std::pow(refit.mean(0) - output(left_out), 2);
    }
    EXPECT_NEAR(process.leave_one_out_rmse, std::sqrt(sum / n), 1e-9);
}

TEST(Fit, MarksOutputsThatCannotBeFittedAndFitsTheOthersAsIfThoseWereNotThere) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 30, 1);
    Eigen::MatrixXd outputs(30, 5);
    outputs.col(0) = smooth_output(inputs, 0.1, 2);
    outputs.col(1).setConstant(0.7);
    outputs.col(2) = smooth_output(inputs, 0.01, 3);
    outputs(4, 2) = nan;
    outputs.col(3) = smooth_output(inputs, 0.3, 4);
    outputs.col(4) = smooth_output(inputs, 0.1, 5);
    outputs(29, 4) = -infinity;
    const FittedProcesses all = fit(inputs, outputs);
    const std::vector<Eigen::Index> good{0, 3};
    const FittedProcesses alone = fit(inputs, outputs(Eigen::all, good));

    ASSERT_EQ(all.processes.size(), 5);
    expect_same(all.processes[0], alone.processes[0]);
    expect_same(all.processes[3], alone.processes[1]);
    EXPECT_EQ(all.processes[1].status, FitStatus::constant_output);
    EXPECT_EQ(all.processes[2].status, FitStatus::non_finite_output);
    EXPECT_EQ(all.processes[4].status, FitStatus::non_finite_output);
    for (const size_t j : {1, 2, 4}) {
        EXPECT_EQ(all.processes[j].spectrum, -1);
        EXPECT_EQ(all.processes[j].hyperparameters.signal_std, 0.0);
        EXPECT_EQ(all.processes[j].negative_log_likelihood, 0.0);
        EXPECT_TRUE(all.weights.col(static_cast<Eigen::Index>(j)).isZero(0.0));
    }
    const Eigen::MatrixXd at = normal_matrix(3, 4, 6);
    const Prediction prediction = all.predict(at);
    const Prediction of_alone = alone.predict(at);
    EXPECT_TRUE(prediction.mean(good, Eigen::all).isApprox(of_alone.mean, 1e-12));
    EXPECT_TRUE(prediction.std_dev(good, Eigen::all).isApprox(of_alone.std_dev, 1e-12));
    for (const Eigen::Index j : {1, 2, 4}) {
        EXPECT_TRUE(prediction.mean.row(j).isZero(0.0));
        EXPECT_TRUE(prediction.std_dev.row(j).isZero(0.0));
    }
}

TEST(Fit, OfConstantOrNoOutputsFitsNothingAndStillPredicts) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 10, 1);
    const FittedProcesses fitted = fit(inputs, Eigen::MatrixXd::Zero(10, 2));
    ASSERT_EQ(fitted.processes.size(), 2);
    EXPECT_EQ(fitted.processes[0].status, FitStatus::constant_output);
    EXPECT_EQ(fitted.processes[1].status, FitStatus::constant_output);
    EXPECT_TRUE(fitted.spectra.empty());
    EXPECT_TRUE(fitted.predict(inputs).mean.isZero(0.0));
    const FittedProcesses none = fit(inputs, Eigen::MatrixXd(10, 0));
    EXPECT_EQ(none.predict(inputs).mean.rows(), 0);
}

TEST(Fit, KeepsTheSpectraThatProcessesUseAndNoOthers) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    Eigen::MatrixXd outputs(40, 6);
    for (Eigen::Index j = 0; j < 6; ++j) {
        outputs.col(j) = smooth_output((0.4 + 0.3 * static_cast<double>(j)) * inputs, 0.05,
                                       10 * static_cast<std::uint64_t>(j));
    }
    const FittedProcesses fitted = fit(inputs, outputs);
    std::vector<bool> used(fitted.spectra.size(), false);
    for (const Process& process : fitted.processes) {
        const auto s = static_cast<size_t>(process.spectrum);
        ASSERT_LT(s, fitted.spectra.size());
        used[s] = true;
        EXPECT_EQ(process.hyperparameters.inverse_length_scale,
                  fitted.spectra[s].inverse_length_scale);
    }
    EXPECT_THAT(used, ::testing::Each(true));
}

TEST(Fit, TakesTwoInputsAndInputsOfWhichMostAreTheSame) {
    Eigen::MatrixXd same = 0.1 * Eigen::MatrixXd::Ones(2, 20);
    same.leftCols(6) = normal_matrix(2, 6, 1);
    for (const Eigen::MatrixXd& inputs : {normal_matrix(2, 2, 1), same}) {
        const FittedProcesses fitted = fit(inputs, smooth_output(inputs, 0.1, 2));
        expect_finite(fitted);
        EXPECT_TRUE(fitted.predict(inputs).mean.allFinite());
    }
}

TEST(Fit, TakesReplicatesAndLearnsTheirNoise) {
    Eigen::MatrixXd inputs(2, 60);
    inputs << normal_matrix(2, 30, 1), normal_matrix(2, 30, 1);
    const FittedProcesses fitted = fit(inputs, smooth_output(inputs, 0.1, 2));
    expect_finite(fitted);
    EXPECT_NEAR(fitted.processes.front().hyperparameters.noise_std, 0.1, 0.03);
}

TEST(Fit, TakesNoiseForNoise) {
    const Eigen::MatrixXd inputs = normal_matrix(5, 200, 1);
    const FittedProcesses fitted = fit(inputs, normal_matrix(200, 3, 2));
    expect_finite(fitted);
    const Prediction prediction = fitted.predict(normal_matrix(5, 10, 3));
    for (Eigen::Index j = 0; j < 3; ++j) {
        // With a very short length scale, signal is noise by another name.
        const Process& process = fitted.processes[j];
        const Eigen::ArrayXd std_dev = prediction.std_dev.row(j).transpose();
        const double noise = process.hyperparameters.noise_std;
        EXPECT_NEAR((std_dev.square() + noise * noise).sqrt().mean(), 1.0, 0.15);
        EXPECT_NEAR(process.leave_one_out_rmse, 1.0, 0.15);
    }
    EXPECT_LT(prediction.mean.cwiseAbs().maxCoeff(), 0.5);
}

TEST(Fit, TakesALinearFunctionWithLongLengthScales) {
    const Eigen::MatrixXd inputs = 1e-3 * normal_matrix(6, 60, 1);
    const Eigen::VectorXd output = inputs.transpose() * normal_matrix(6, 1, 2);
    const FittedProcesses fitted = fit(inputs, output);
    expect_finite(fitted);
    const Eigen::MatrixXd at = 1e-3 * normal_matrix(6, 20, 3);
    const Eigen::VectorXd truth = at.transpose() * normal_matrix(6, 1, 2);
    EXPECT_LT((fitted.predict(at).mean.transpose() - truth).cwiseAbs().maxCoeff(), 2e-7);
    // Longer than 30 times the distances of the inputs.
    EXPECT_LT(fitted.processes.front().hyperparameters.inverse_length_scale, 1.0 / 0.1);
}

TEST(Fit, IsTheSameInOtherUnits) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    const Eigen::VectorXd output = smooth_output(inputs, 0.1, 2);
    const Process metres = fit(inputs, output).processes.front();
    const Process other = fit(1e3 * inputs, 1e-6 * output).processes.front();
    EXPECT_NEAR(other.hyperparameters.inverse_length_scale /
                    (1e-3 * metres.hyperparameters.inverse_length_scale),
                1.0, 1e-6);
    EXPECT_NEAR(other.hyperparameters.signal_std / (1e-6 * metres.hyperparameters.signal_std), 1.0,
                1e-4);
    EXPECT_NEAR(other.hyperparameters.noise_std / (1e-6 * metres.hyperparameters.noise_std), 1.0,
                1e-4);
    EXPECT_NEAR(other.leave_one_out_rmse / (1e-6 * metres.leave_one_out_rmse), 1.0, 1e-4);
}

TEST(FitSettings, LimitTheDecompositionsAndReportEach) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    for (const int most : {1, 2, 5}) {
        std::vector<int> reported;
        const Progress progress{.report = [&](std::string_view stage, int made, int total) {
            EXPECT_EQ(stage, "training");
            EXPECT_EQ(total, most);
            reported.push_back(made);
        }};
        const FittedProcesses fitted =
            fit(inputs, smooth_output(inputs, 0.1, 2), {.max_spectra = most}, progress);
        ASSERT_EQ(reported.size(), static_cast<size_t>(most));
        for (int k = 0; k < most; ++k) {
            EXPECT_EQ(reported[k], k);
        }
        EXPECT_EQ(fitted.decompositions, most);
        EXPECT_FALSE(fitted.is_converged);
        expect_finite(fitted);
    }
}

TEST(Fit, SaysWhetherItsSearchEnded) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    const FittedProcesses fitted = fit(inputs, smooth_output(inputs, 0.1, 2), {.max_spectra = 100});
    EXPECT_TRUE(fitted.is_converged);
    EXPECT_LT(fitted.decompositions, 100);
}

TEST(FitSettings, LetTheProgressGiveUp) {
    int reported = 0;
    const Progress progress{.report = [&](std::string_view, int, int) { ++reported; },
                            .stop_requested = [&] { return reported == 2; }};
    const Eigen::MatrixXd inputs = normal_matrix(3, 20, 1);
    EXPECT_THROW((void)fit(inputs, smooth_output(inputs, 0.1, 2), {}, progress), Interrupted);
    EXPECT_EQ(reported, 2);
}

TEST(FitSettings, HoldTheNoiseRatioWithinItsBounds) {
    const FitSettings settings{.noise_ratio = NoiseRatioBounds{.lower = 0.25, .upper = 0.25}};
    const Eigen::MatrixXd inputs = normal_matrix(3, 40, 1);
    const Hyperparameters theta =
        fit(inputs, smooth_output(inputs, 0.01, 2), settings).processes.front().hyperparameters;
    EXPECT_NEAR(theta.noise_std / theta.signal_std, 0.5, 1e-9);
}

TEST(FitSettings, BoundLambdaByTheDistancesOfTheInputs) {
    // Equally spaced on a circle: all nearest neighbours are as far apart.
    constexpr Eigen::Index n = 24;
    Eigen::MatrixXd inputs(2, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double angle = 2.0 * std::acos(-1.0) * static_cast<double>(i) / n;
        inputs.col(i) = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    FitSettings settings{.largest_scaled_lambda = 0.5, .max_spectra = 40};
    const double nearest = (inputs.col(0) - inputs.col(1)).norm();
    Eigen::VectorXd jagged(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        jagged(i) = i % 3 == 0 ? 1.0 : -1.0;
    }
    const double rough =
        fit(inputs, jagged, settings).processes.front().hyperparameters.inverse_length_scale;
    EXPECT_LE(rough, 0.5 / nearest * (1.0 + 1e-9));
    settings.smallest_scaled_lambda = 0.2;
    const double smooth = fit(inputs, inputs.row(0).transpose(), settings)
                              .processes.front()
                              .hyperparameters.inverse_length_scale;
    EXPECT_GE(smooth, 0.2 / 2.0);  // no two points are further apart than 2
}

TEST(Fit, RefusesInputsAndOutputsThatCannotBeMeant) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 10, 1);
    const Eigen::VectorXd output = normal_matrix(10, 1, 2);
    expect_refused([&] { return fit(inputs, output.head(9)); }, "10 inputs, but 9 rows of outputs");
    expect_refused([&] { return fit(inputs.leftCols(1), output.head(1)); },
                   "1 training inputs, expected at least 2");
    expect_refused([&] { return fit(inputs.topRows(0), output); }, "without dimensions");
    for (const double value : {nan, infinity}) {
        Eigen::MatrixXd broken = inputs;
        broken(1, 7) = value;
        expect_refused([&] { return fit(broken, output); }, "not finite");
    }
    for (const double value : {0.0, 0.1, 1e6 / 3.0}) {
        expect_refused([&] { return fit(Eigen::MatrixXd::Constant(3, 10, value), output); },
                       "all the same");
    }
}

TEST(FitSettings, AreRefusedOutOfRange) {
    const Eigen::MatrixXd inputs = normal_matrix(3, 10, 1);
    const auto expect_setting_refused = [&](auto&& change, const std::string& field) {
        FitSettings settings;
        change(settings);
        expect_refused([&] { return fit(inputs, normal_matrix(10, 1, 2), settings); }, field);
    };
    for (const double value : {0.0, -1.0, nan, infinity}) {
        expect_setting_refused([&](auto& s) { s.smallest_scaled_lambda = value; },
                               "smallest_scaled_lambda");
        expect_setting_refused([&](auto& s) { s.largest_scaled_lambda = value; },
                               "largest_scaled_lambda");
        expect_setting_refused([&](auto& s) { s.noise_ratio = {.lower = value, .upper = 1.0}; },
                               "noise_ratio.lower");
    }
    for (const double value : {-1e-9, nan}) {
        expect_setting_refused([&](auto& s) { s.relative_tolerance = value; },
                               "relative_tolerance");
    }
    for (const double value : {0.01, nan, infinity}) {
        expect_setting_refused([&](auto& s) { s.noise_ratio = {.lower = 0.1, .upper = value}; },
                               "noise_ratio.upper");
    }
    expect_setting_refused([](auto& s) { s.max_spectra = 0; }, "max_spectra");
    expect_setting_refused([](auto& s) { s.smallest_scaled_lambda = 100.0; }, "nothing between");
}

}  // namespace
}  // namespace taut::gp
