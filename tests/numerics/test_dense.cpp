// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a wrong leading dimension, transposition or triangle in calls of BLAS and LAPACK,
// which shows only for matrices that are not square, or of several sizes.
#include "numerics/dense.hpp"
#include "numerics/serial_blas.hpp"

#include <cblas.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "support/textbook.hpp"

namespace taut::gp {
namespace {

using test::normal_matrix;

TEST(Product, IsThatOfTheMatricesForUnequalSizes) {
    const Eigen::MatrixXd a = normal_matrix(5, 3, 1);
    const Eigen::MatrixXd b = normal_matrix(3, 7, 2);
    EXPECT_TRUE(product(a, b).isApprox(a.lazyProduct(b), 1e-14));
    EXPECT_TRUE(transposed_product(a.transpose(), b).isApprox(a.lazyProduct(b), 1e-14));
    EXPECT_EQ(product(a, Eigen::MatrixXd(3, 0)).cols(), 0);
    EXPECT_EQ(product(Eigen::MatrixXd(5, 0), Eigen::MatrixXd(0, 2)), Eigen::MatrixXd::Zero(5, 2));
}

TEST(Gram, IsTheProductOfTheTransposedWithItself) {
    for (const Eigen::Index columns : {0, 3, 64, 150}) {  // of one task, and of several
        const Eigen::MatrixXd a = normal_matrix(5, columns, 1);
        EXPECT_TRUE(gram(a).isApprox(a.transpose().lazyProduct(a), 1e-13)) << columns;
    }
    EXPECT_EQ(gram(Eigen::MatrixXd(0, 2)), Eigen::MatrixXd::Zero(2, 2));
}

TEST(QuadraticForms, ReadTheLowerTriangleAlone) {
    const Eigen::MatrixXd square = normal_matrix(6, 6, 1);
    const Eigen::MatrixXd symmetric = square + square.transpose();
    Eigen::MatrixXd lower = symmetric;
    lower.triangularView<Eigen::StrictlyUpper>().fill(1e6);
    for (const Eigen::Index columns : {4, 150}) {  // of one task, and of several
        const Eigen::MatrixXd b = normal_matrix(6, columns, 2);
        const Eigen::VectorXd expected = (b.transpose() * symmetric * b).diagonal();
        EXPECT_TRUE(quadratic_forms(lower, b).isApprox(expected, 1e-13));
    }
    EXPECT_EQ(quadratic_forms(lower, Eigen::MatrixXd(6, 0)).size(), 0);
}

TEST(Cholesky, SolvesAndInvertsByTheLowerTriangleAlone) {
    const Eigen::MatrixXd root = normal_matrix(6, 9, 1);
    const Eigen::MatrixXd matrix = root * root.transpose();
    Eigen::MatrixXd lower = matrix;
    lower.triangularView<Eigen::StrictlyUpper>().fill(1e6);
    const Cholesky factor(lower);
    const Eigen::MatrixXd b = normal_matrix(6, 4, 2);
    EXPECT_TRUE((matrix * factor.solve(b)).isApprox(b, 1e-11));
    const Eigen::MatrixXd half = factor.solve_lower(b);
    EXPECT_TRUE((half.transpose() * half).isApprox(b.transpose() * factor.solve(b), 1e-11));
    const Eigen::MatrixXd inverse = factor.inverse_lower().selfadjointView<Eigen::Lower>();
    EXPECT_TRUE((matrix * inverse).isIdentity(1e-10));
}

TEST(Cholesky, RefusesAMatrixThatIsNotPositiveDefinite) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3, 3);
    matrix(2, 2) = -1.0;
    EXPECT_THROW(Cholesky{matrix}, std::runtime_error);
}

TEST(SymmetricEigen, GivesAscendingValuesAndOrthonormalVectors) {
    const Eigen::MatrixXd square = normal_matrix(8, 8, 3);
    const Eigen::MatrixXd symmetric = square + square.transpose();
    const auto [values, vectors] = symmetric_eigen(symmetric);
    for (Eigen::Index i = 1; i < values.size(); ++i) {
        EXPECT_LE(values(i - 1), values(i));
    }
    EXPECT_TRUE((vectors.transpose() * vectors).isIdentity(1e-13));
    EXPECT_TRUE((vectors * values.asDiagonal() * vectors.transpose()).isApprox(symmetric, 1e-13));
}

TEST(SymmetricEigen, RefusesAMatrixThatIsNotFinite) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(4, 4);
    matrix(2, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)symmetric_eigen(matrix), std::runtime_error);
}

/// Parts of larger matrices: small products by Eigen, large ones by BLAS.
TEST(AddedProducts, AreThoseOfPartsOfMatrices) {
    for (const Eigen::Index n : {2, 40}) {
        const Eigen::MatrixXd a = normal_matrix(2 * n + 3, n + 2, 1);
        const Eigen::MatrixXd b = normal_matrix(n + 5, n + 3, 2);
        const auto A = a.block(1, 1, 2 * n, n);
        const auto B = b.block(2, 2, n, n + 1);
        const Eigen::MatrixXd before = normal_matrix(2 * n + 2, n + 4, 3);
        const Eigen::MatrixXd expected =
            before.block(1, 2, 2 * n, n + 1) - 0.5 * Eigen::MatrixXd(A) * Eigen::MatrixXd(B);
        const Eigen::MatrixXd at = A.transpose();
        const Eigen::MatrixXd bt = B.transpose();

        Eigen::MatrixXd c = before;
        add_product(c.block(1, 2, 2 * n, n + 1), -0.5, A, B);
        EXPECT_TRUE(c.block(1, 2, 2 * n, n + 1).isApprox(expected, 1e-13));
        EXPECT_EQ(c.col(1), before.col(1));
        EXPECT_EQ(c.row(2 * n + 1), before.row(2 * n + 1));
        c = before;
        add_product_transposed(c.block(1, 2, 2 * n, n + 1), -0.5, A, bt);
        EXPECT_TRUE(c.block(1, 2, 2 * n, n + 1).isApprox(expected, 1e-13));
        c = before;
        add_transposed_product(c.block(1, 2, 2 * n, n + 1), -0.5, at, B);
        EXPECT_TRUE(c.block(1, 2, 2 * n, n + 1).isApprox(expected, 1e-13));
    }
}

TEST(SerialBlas, RestoresTheThreadsWithTheLastObject) {
    const int before = openblas_get_num_threads();
    {
        const SerialBlas outer;
        {
            const SerialBlas inner;
        }
        EXPECT_EQ(openblas_get_num_threads(), 1);
    }
    EXPECT_EQ(openblas_get_num_threads(), before);
}

}  // namespace
}  // namespace taut::gp
