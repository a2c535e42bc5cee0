// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a decomposition that is not that of the correlation matrix, eigenvalues below zero
// (whose logarithm would spoil a likelihood in silence), and bad arguments handed on to LAPACK.
#include "support/not_finite.hpp"
#include "taut/gp/spectrum.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/textbook.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {
namespace {

using test::infinity;
using test::nan;
using test::normal_matrix;

Eigen::MatrixXd some_distances() {
    const Eigen::MatrixXd x = normal_matrix(3, 20, 1);
    return squared_distances(x, x);
}

TEST(KernelSpectrum, ReconstructsTheCorrelationMatrix) {
    const Eigen::MatrixXd distances = some_distances();
    for (const double lambda : {1e-3, 0.1, 1.0, 10.0}) {
        const KernelSpectrum spectrum = kernel_spectrum(distances, lambda);
        const Eigen::MatrixXd& Q = spectrum.eigenvectors;
        const Eigen::MatrixXd R = Q * spectrum.eigenvalues.asDiagonal() * Q.transpose();
        EXPECT_LT((R - correlation(distances, lambda)).cwiseAbs().maxCoeff(), 1e-13) << lambda;
        EXPECT_TRUE((Q.transpose() * Q).isIdentity(1e-13)) << lambda;
        EXPECT_EQ(spectrum.inverse_length_scale, lambda);
    }
}

TEST(KernelSpectrum, HasNoEigenvalueBelowZeroWhereTheMatrixIsSingularToRounding) {
    const KernelSpectrum spectrum = kernel_spectrum(some_distances(), 1e-4);
    EXPECT_EQ(spectrum.eigenvalues.minCoeff(), 0.0);  // some were negative by rounding
    EXPECT_NEAR(spectrum.eigenvalues.maxCoeff(), 20.0, 1e-5);
}

TEST(KernelSpectrum, RefusesWhatIsNoCorrelationMatrix) {
    for (const double lambda : {0.0, -1.0, nan, infinity}) {
        EXPECT_THROW((void)kernel_spectrum(some_distances(), lambda), std::invalid_argument)
            << lambda;
    }
    for (const double distance : {nan, infinity}) {
        Eigen::MatrixXd distances = some_distances();
        distances(4, 2) = distance;
        EXPECT_THROW((void)kernel_spectrum(distances, 1.0), std::invalid_argument) << distance;
    }
    EXPECT_THROW((void)kernel_spectrum(Eigen::MatrixXd::Zero(3, 2), 1.0), std::invalid_argument);
    EXPECT_THROW((void)kernel_spectrum(Eigen::MatrixXd(), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace taut::gp
