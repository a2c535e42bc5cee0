// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against squared distances that lose their digits to cancellation where the inputs lie far
// from the origin, as coordinates of a survey do, and against another kernel than the paper's.
#include "taut/gp/kernel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/textbook.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

Eigen::MatrixXd direct_squared_distances(const Eigen::MatrixXd& x, const Eigen::MatrixXd& z) {
    return Eigen::MatrixXd::NullaryExpr(x.cols(), z.cols(), [&](Eigen::Index i, Eigen::Index j) {
        return (x.col(i) - z.col(j)).squaredNorm();
    });
}

RC_GTEST_PROP(SquaredDistances, AreThoseOfAllPairsWhereverTheInputsLie, ()) {
    const auto d = *rc::gen::inRange<Eigen::Index>(1, 20);
    const auto n = *rc::gen::inRange<Eigen::Index>(1, 15);
    const auto k = *rc::gen::inRange<Eigen::Index>(1, 15);
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const double offset = std::pow(10.0, *rc::gen::inRange(0, 7));
    const Eigen::VectorXd origin = offset * normal_matrix(d, 1, seed + 2);
    const Eigen::MatrixXd x = normal_matrix(d, n, seed).colwise() + origin;
    const Eigen::MatrixXd z = normal_matrix(d, k, seed + 1).colwise() + origin;

    // The middle that is taken off is rounded, by about an ulp of the coordinates; the distances of
    // points about it then lose digits of numbers of the order of d, not of d times offset^2.
    const Eigen::MatrixXd error = squared_distances(x, z) - direct_squared_distances(x, z);
    const double rounding = 1e-13 * static_cast<double>(d) * (1.0 + 1e-2 * offset);
    RC_ASSERT(error.cwiseAbs().maxCoeff() < rounding);
    const Eigen::MatrixXd own = squared_distances(x);
    RC_ASSERT((own - squared_distances(x, x)).cwiseAbs().maxCoeff() < rounding);
    RC_ASSERT(own == own.transpose());
}

RC_GTEST_PROP(SquaredDistances, AreNeverNegative, ()) {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    Eigen::MatrixXd x = normal_matrix(7, 6, seed);
    x.rightCols(3) = x.leftCols(3);
    const double distance = std::pow(10.0, -*rc::gen::inRange(6, 17));
    x.rightCols(3) += distance * normal_matrix(7, 3, seed + 1);
    RC_ASSERT(squared_distances(x, x).minCoeff() >= 0.0);
    RC_ASSERT(squared_distances(x).minCoeff() >= 0.0);
}

TEST(Correlation, IsThePapersKernelWithSignalStdOne) {
    const Eigen::MatrixXd x = normal_matrix(4, 6, 1);
    const Eigen::MatrixXd z = normal_matrix(4, 5, 2);
    const double lambda = 0.7;
    const Eigen::MatrixXd expected = test::textbook_kernel(
        x, z, {.inverse_length_scale = lambda, .signal_std = 1.0, .noise_std = 0.0});
    const Eigen::MatrixXd R = correlation(direct_squared_distances(x, z), lambda);
    EXPECT_LT((R - expected).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace taut::gp
