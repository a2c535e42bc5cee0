// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against statistics that are not the paper's: another divisor, a mean taken over the other
// axis, an error with the wrong sign. Compares with the equations written out as loops.

#include "taut/study/error_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "study/error_sums.hpp"
#include "support/refusals.hpp"

namespace {

using namespace taut;

/// Numbers as of millimetres, reproducible.
Eigen::MatrixXd random_matrix(int rows, int columns, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0.0005, 0.003);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
}

/// Eqs. ei, m_ei, std, MSE and MRSE, as they stand in the paper.
struct ByHand {
    std::vector<double> mean;
    std::vector<double> std_dev;
    double mse = 0.0;
    double mrse = 0.0;

    ByHand(const Eigen::MatrixXd& truth, const Eigen::MatrixXd& estimate) {
        const auto edges = static_cast<int>(truth.rows());
        const auto samples = static_cast<int>(truth.cols());
        for (int i = 0; i < edges; ++i) {
            double sum = 0.0;
            double squares = 0.0;
            double squared_truths = 0.0;
            for (int k = 0; k < samples; ++k) {
                const double e = truth(i, k) - estimate(i, k);
                sum += e;
                squares += e * e;
                squared_truths += truth(i, k) * truth(i, k);
            }
            mean.push_back(sum / samples);
            double deviations = 0.0;
            for (int k = 0; k < samples; ++k) {
                const double e = truth(i, k) - estimate(i, k);
                deviations += (e - mean.back()) * (e - mean.back());
            }
            std_dev.push_back(std::sqrt(deviations / samples));
            mse += squares / samples / edges;
            mrse += squares / squared_truths / edges;
        }
    }
};

RC_GTEST_PROP(LengthErrors, AreTheEquationsOfThePaper, ()) {
    const int edges = *rc::gen::inRange(1, 12);
    const int samples = *rc::gen::inRange(1, 9);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    const Eigen::MatrixXd truth = random_matrix(edges, samples, seed);
    const Eigen::MatrixXd estimate = random_matrix(edges, samples, seed + 1);
    const LengthErrors errors = length_errors(truth, estimate);
    const ByHand expected(truth, estimate);
    RC_ASSERT(errors.mean.size() == edges);
    RC_ASSERT(errors.std_dev.size() == edges);
    double largest_mean = 0.0;
    double sum_of_stds = 0.0;
    for (int i = 0; i < edges; ++i) {
        const auto at = static_cast<size_t>(i);
        RC_ASSERT(std::abs(errors.mean(i) - expected.mean[at]) < 1e-15);
        RC_ASSERT(std::abs(errors.std_dev(i) - expected.std_dev[at]) < 1e-15);
        largest_mean = std::max(largest_mean, std::abs(expected.mean[at]));
        sum_of_stds += expected.std_dev[at];
    }
    RC_ASSERT(std::abs(errors.mse - expected.mse) < 1e-12 * expected.mse);
    RC_ASSERT(std::abs(errors.mrse - expected.mrse) < 1e-12 * expected.mrse);
    RC_ASSERT(std::abs(errors.mean_max_abs() - largest_mean) < 1e-15);
    RC_ASSERT(std::abs(errors.std_mean() - sum_of_stds / edges) < 1e-15);
}

/// Errors of two edges in two samples: (1, -1) and (2, 4).
const Eigen::MatrixXd small_truth{{3.0, 1.0}, {2.0, 4.0}};
const Eigen::MatrixXd small_estimate{{2.0, 2.0}, {0.0, 0.0}};

TEST(LengthErrors, LeaveEdgesThatNeverDeviateOutOfTheRelativeError) {
    Eigen::MatrixXd truth(3, 2);
    truth << small_truth, 0.0, 0.0;
    Eigen::MatrixXd estimate(3, 2);
    estimate << small_estimate, 0.5, -0.5;
    const LengthErrors errors = length_errors(truth, estimate);
    EXPECT_DOUBLE_EQ(errors.mrse, length_errors(small_truth, small_estimate).mrse);
    EXPECT_DOUBLE_EQ(errors.mse, (22.0 + 0.5) / 6.0);
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(2, 3);
    EXPECT_EQ(length_errors(zero, zero).mrse, 0.0);
}

TEST(LengthErrors, RefuseSizesThatDifferOrAreZero) {
    const auto refusal = [](Eigen::Index rows, Eigen::Index columns, Eigen::Index other_rows,
                            Eigen::Index other_columns) {
        return test::refusal_of([&] {
            return length_errors(Eigen::MatrixXd::Zero(rows, columns),
                                 Eigen::MatrixXd::Zero(other_rows, other_columns));
        });
    };
    EXPECT_THAT(refusal(3, 4, 4, 3),
                testing::AllOf(testing::HasSubstr("3 x 4"), testing::HasSubstr("4 x 3")));
    EXPECT_THAT(refusal(3, 4, 3, 5), testing::HasSubstr("3 x 5"));
    EXPECT_THAT(refusal(3, 4, 2, 4), testing::HasSubstr("2 x 4"));
    EXPECT_THAT(refusal(0, 4, 0, 4), testing::HasSubstr("0 x 4"));
    EXPECT_THAT(refusal(3, 0, 3, 0), testing::HasSubstr("3 x 0"));
}

TEST(FormErrorSummary, IsOfTheDistancesBetweenTwoForms) {
    const Eigen::VectorXd one{{0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 5.0, 6.0, 7.0}};
    const Eigen::VectorXd other{{1.0, 2.0, 2.0, 1.0, 4.0, -3.0, 5.0, 6.0, 7.0}};
    const Eigen::VectorXd distances = node_distances(one, other);
    ASSERT_EQ(distances.size(), 3);
    EXPECT_DOUBLE_EQ(distances(0), 3.0);
    EXPECT_DOUBLE_EQ(distances(1), 5.0);
    EXPECT_DOUBLE_EQ(distances(2), 0.0);
    const FormErrorSummary summary = summarise(distances);
    EXPECT_DOUBLE_EQ(summary.max, 5.0);
    EXPECT_DOUBLE_EQ(summary.min, 0.0);
    EXPECT_DOUBLE_EQ(summary.mean, 8.0 / 3.0);
    EXPECT_DOUBLE_EQ(summary.rmse, std::sqrt(34.0 / 3.0));
    EXPECT_THROW((void)node_distances(one.head(6), other), std::invalid_argument);
    EXPECT_THROW((void)node_distances(one.head(7), other.head(7)), std::invalid_argument);
    EXPECT_THROW((void)summarise(Eigen::VectorXd(0)), std::invalid_argument);
}

}  // namespace
