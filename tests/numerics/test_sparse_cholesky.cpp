// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against solutions in another order than that of the matrix, and against failure if
// rounding errors make a pivot negative.
#include "numerics/sparse_cholesky.hpp"

#include <gtest/gtest.h>

namespace {

using namespace taut;

/// The Laplacian of a square grid with unequal weights, plus a shift of its diagonal.
Eigen::SparseMatrix<double> laplacian(int side, double shift) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto join = [&](int a, int b) {
        const double weight = 1.0 + 0.5 * ((3 * a + 5 * b) % 7);
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
    };
    for (int j = 0; j < side * side; ++j) {
        entries.emplace_back(j, j, shift);
        if (j % side + 1 < side) {
            join(j, j + 1);
        }
        if (j + side < side * side) {
            join(j, j + side);
        }
    }
    Eigen::SparseMatrix<double> matrix(side * side, side * side);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

TEST(SparseCholesky, SolvesForEachColumn) {
    for (const int side : {3, 80}) {  // by either factor
        const Eigen::SparseMatrix<double> matrix = laplacian(side, 0.1);
        const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(matrix.rows(), 2);
        const Eigen::MatrixXd found = SparseCholesky(matrix).solve(matrix * expected);
        EXPECT_LT((found - expected).norm(), 1e-11 * expected.norm());
    }
}

TEST(SparseCholesky, SolvesAMatrixThatIsSlightlyIndefinite) {
    const Eigen::SparseMatrix<double> matrix = laplacian(80, -1e-5);
    const Eigen::VectorXd expected = Eigen::VectorXd::Random(matrix.rows());
    const Eigen::VectorXd found = SparseCholesky(matrix).solve(matrix * expected);
    EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
}

}  // namespace
