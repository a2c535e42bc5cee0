// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a spectrum of low rank that misses directions that count, or understates what it
// leaves out: predictions would be surer than the exact ones.
#include "gp/low_rank_spectrum.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Eigenvalues>

#include "gp/correlation_product.hpp"
#include "support/textbook.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

constexpr Eigen::Index n = 300;  // more than one block

Eigen::VectorXd eigenvalues_of(const Eigen::MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
        .eigenvalues();
}

Eigen::MatrixXd left_out_of(const Eigen::MatrixXd& inputs, const KernelSpectrum& spectrum) {
    const Eigen::MatrixXd& Q = spectrum.eigenvectors;
    return correlation(squared_distances(inputs), spectrum.inverse_length_scale) -
           Q * spectrum.eigenvalues.asDiagonal() * Q.transpose();
}

TEST(CorrelationProduct, IsThatOfTheWholeMatrix) {
    // Far from the origin, where squares lose digits.
    const Eigen::MatrixXd inputs = normal_matrix(3, n, 1).array() + 1e3;
    const Eigen::MatrixXd b = normal_matrix(n, 4, 2);
    const Eigen::MatrixXd expected = correlation(squared_distances(inputs), 0.5) * b;
    EXPECT_LT((correlation_product(inputs, 0.5, b) - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CorrelationProduct, GivesUpWhereAStopIsRequested) {
    const Progress progress{.report = {}, .stop_requested = [] { return true; }};
    EXPECT_THROW(
        (void)correlation_product(normal_matrix(3, n, 1), 0.5, normal_matrix(n, 1, 2), progress),
        Interrupted);
}

TEST(LowRankSpectrum, LeavesOutNothingBelowZeroAndNoMoreThanItReports) {
    for (const Eigen::Index dimensions : {1, 3, 20}) {
        const Eigen::MatrixXd inputs = normal_matrix(dimensions, n, 1);
        for (const double lambda : {1e-3, 0.05, 0.3, 1.0, 5.0}) {
            for (const Eigen::Index rank : {1, 10, 60, 150}) {
                SCOPED_TRACE(testing::Message() << dimensions << ' ' << lambda << ' ' << rank);
                const KernelSpectrum spectrum = low_rank_spectrum(inputs, lambda, rank);
                const Eigen::MatrixXd& Q = spectrum.eigenvectors;
                ASSERT_LE(Q.cols(), rank);
                ASSERT_EQ(spectrum.eigenvalues.size(), Q.cols());
                EXPECT_TRUE((Q.transpose() * Q).isIdentity(1e-12));
                EXPECT_GT(spectrum.eigenvalues.minCoeff(), 0.0);
                const Eigen::VectorXd left_out = eigenvalues_of(left_out_of(inputs, spectrum));
                EXPECT_GT(left_out.minCoeff(), -1e-11);
                EXPECT_LE(left_out.maxCoeff(), spectrum.tail_largest);
                EXPECT_LE(spectrum.tail_mean, spectrum.tail_largest);
                EXPECT_NEAR(spectrum.tail_mean * static_cast<double>(n - Q.cols()), left_out.sum(),
                            1e-10);
            }
        }
    }
}

TEST(LowRankSpectrum, LeavesOutAtMostTwiceAsMuchAsTheBestOfItsRank) {
    const Eigen::MatrixXd inputs = normal_matrix(3, n, 1);
    const Eigen::VectorXd all = eigenvalues_of(correlation(squared_distances(inputs), 0.3));
    for (const Eigen::Index rank : {10, 40, 100}) {
        const KernelSpectrum spectrum = low_rank_spectrum(inputs, 0.3, rank);
        const double least = all.head(n - rank).sum();
        EXPECT_LT(left_out_of(inputs, spectrum).trace(), 2.0 * least + 1e-11) << rank;
    }
}

TEST(LowRankSpectrum, LeavesOutNoMoreThanItReportsOfInputsThatAreTogetherOutsideItsPart) {
    constexpr Eigen::Index many = 1500;
    constexpr Eigen::Index rank = 200;
    constexpr double lambda = 3.0;
    for (const int together : {4, 5}) {
        Eigen::MatrixXd inputs = normal_matrix(6, many, 1);
        for (Eigen::Index i = 0; i + 1 < many; i += 2) {
            inputs.col(i + 1) = inputs.col(i) + 1e-3 * normal_matrix(6, 1, 2).col(0);
        }
        // The middle one of each of two neighbours of the part, as long as there are some.
        const std::vector<Eigen::Index> part = spread_part(many, rank);
        std::vector<Eigen::Index> outside;
        for (size_t k = 0; k + 1 < part.size() && std::ssize(outside) < together; k += 35) {
            if (part[k + 1] - part[k] > 1) {
                outside.push_back(part[k] + 1);
            }
        }
        ASSERT_EQ(std::ssize(outside), together);
        for (const Eigen::Index i : outside) {
            inputs.col(i).setConstant(2.0);
        }
        const KernelSpectrum spectrum = low_rank_spectrum(inputs, lambda, rank);
        const Eigen::MatrixXd left_out = correlation(squared_distances(inputs), lambda) -
                                         spectrum.eigenvectors * spectrum.eigenvalues.asDiagonal() *
                                             spectrum.eigenvectors.transpose();
        EXPECT_LE(eigenvalues_of(left_out).maxCoeff(), spectrum.tail_largest) << together;
        EXPECT_LE(spectrum.tail_largest, 1.6 * eigenvalues_of(left_out).maxCoeff()) << together;
    }
}

TEST(LowRankSpectrum, OfFullRankIsTheWholeOne) {
    const Eigen::MatrixXd inputs = normal_matrix(3, n, 1);
    const KernelSpectrum spectrum = low_rank_spectrum(inputs, 3.0, n);
    const KernelSpectrum expected = kernel_spectrum(squared_distances(inputs), 3.0);
    ASSERT_TRUE(spectrum.is_whole());
    EXPECT_LT((spectrum.eigenvalues - expected.eigenvalues).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(spectrum.tail_mean, 0.0);
    EXPECT_EQ(spectrum.tail_largest, 0.0);
}

TEST(LowRankSpectrum, KeepsNoMoreDirectionsThanInputsThatDiffer) {
    Eigen::MatrixXd inputs(2, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        inputs.col(i) = Eigen::Vector2d(static_cast<double>(i % 5), 1.0);
    }
    const KernelSpectrum spectrum = low_rank_spectrum(inputs, 1.0, 100);
    EXPECT_EQ(spectrum.eigenvalues.size(), 5);
    EXPECT_LT(spectrum.tail_largest, 1e-9);
}

TEST(LowRankSpectrum, IsTheSameForAnyNumberOfThreads) {
    const Eigen::MatrixXd inputs = normal_matrix(3, n, 1);
    const KernelSpectrum by_all = low_rank_spectrum(inputs, 0.5, 60);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const KernelSpectrum by_one = low_rank_spectrum(inputs, 0.5, 60);
    EXPECT_EQ(by_all.eigenvalues, by_one.eigenvalues);
    EXPECT_EQ(by_all.eigenvectors, by_one.eigenvectors);
    EXPECT_EQ(by_all.tail_largest, by_one.tail_largest);
}

}  // namespace
}  // namespace taut::gp
