// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against weights that do not solve their equations, and residuals that are understated.
#include "gp/weights.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "gp/low_rank_spectrum.hpp"
#include "support/textbook.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

constexpr Eigen::Index row_count = 200;
constexpr double lambda = 0.4;

struct Equations {
    Eigen::MatrixXd inputs = normal_matrix(3, row_count, 1);
    Eigen::MatrixXd outputs =
        inputs.transpose() * normal_matrix(3, 4, 2) + normal_matrix(row_count, 4, 3);
    Eigen::VectorXd noise_ratios = Eigen::Vector4d(1e-3, 0.1, 1e-5, 10.0);

    [[nodiscard]] Eigen::MatrixXd matrix(Eigen::Index j) const {
        Eigen::MatrixXd A = correlation(squared_distances(inputs), lambda);
        A.diagonal().array() += noise_ratios(j);
        return A;
    }
};

TEST(WeightsBySpectrum, OfAWholeOneSolveTheEquations) {
    const Equations it;
    const Eigen::MatrixXd weights = weights_by_spectrum(
        kernel_spectrum(squared_distances(it.inputs), lambda), it.outputs, it.noise_ratios);
    for (Eigen::Index j = 0; j < 4; ++j) {
        EXPECT_LT((it.matrix(j) * weights.col(j) - it.outputs.col(j)).norm(), 1e-7) << j;
    }
}

TEST(WeightsBySpectrum, OfALowRankSolveThoseOfTheMatrixThatItStandsFor) {
    const Equations it;
    const KernelSpectrum spectrum = low_rank_spectrum(it.inputs, lambda, 30);
    const Eigen::MatrixXd& Q = spectrum.eigenvectors;
    const Eigen::MatrixXd weights = weights_by_spectrum(spectrum, it.outputs, it.noise_ratios);
    for (Eigen::Index j = 0; j < 4; ++j) {
        Eigen::MatrixXd A = Q * spectrum.eigenvalues.asDiagonal() * Q.transpose() +
                            spectrum.tail_mean * (Eigen::MatrixXd::Identity(row_count, row_count) -
                                                  Q * Q.transpose());
        A.diagonal().array() += it.noise_ratios(j);
        EXPECT_LT((A * weights.col(j) - it.outputs.col(j)).norm(), 1e-7) << j;
    }
}

TEST(RefinedWeights, ReportTheirResidualsWhichAreSmallerThanBefore) {
    const Equations it;
    const KernelSpectrum spectrum = low_rank_spectrum(it.inputs, lambda, 30);
    const Eigen::MatrixXd before = weights_by_spectrum(spectrum, it.outputs, it.noise_ratios);
    const RefinedWeights after =
        refined_weights(it.inputs, spectrum, it.outputs, it.noise_ratios, Eigen::VectorXd::Zero(4));
    for (Eigen::Index j = 0; j < 4; ++j) {
        const Eigen::MatrixXd A = it.matrix(j);
        const Eigen::VectorXd exact = A.llt().solve(it.outputs.col(j));
        const Eigen::VectorXd residual = it.outputs.col(j) - A * after.weights.col(j);
        EXPECT_NEAR(after.residuals(j), std::sqrt(residual.squaredNorm() / row_count),
                    1e-6 * after.residuals(j) + 1e-9);
        // In the norm in which conjugate gradients descend.
        const Eigen::VectorXd off = after.weights.col(j) - exact;
        const Eigen::VectorXd was_off = before.col(j) - exact;
        EXPECT_LT(off.dot(A * off), was_off.dot(A * was_off) + 1e-12) << j;
        // The means at the inputs are no further off than the residual. (approximation-error)
        const Eigen::VectorXd means_off = correlation(squared_distances(it.inputs), lambda) * off;
        EXPECT_LE(means_off.norm(), residual.norm() + 1e-7) << j;
    }
}

}  // namespace
}  // namespace taut::gp
