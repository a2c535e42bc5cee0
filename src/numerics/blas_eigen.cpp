// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "numerics/blas.hpp"

namespace taut {
namespace {

/// Calls function(op(A)).
template <class Function>
void with(const ConstMatrixPart& A, Op op, const Function& function) {
    if (op == Op::as_it_is) {
        function(A);
    } else {
        function(A.transpose());
    }
}

}  // namespace

void multiply(double alpha, const ConstMatrixPart& A, Op op_A, const ConstMatrixPart& B, Op op_B,
              double beta, MatrixPart C) {
    if (beta == 0.0) {
        C.setZero();
    } else if (beta != 1.0) {
        C *= beta;
    }
    with(A, op_A, [&](const auto& left) {
        with(B, op_B, [&](const auto& right) { C.noalias() += alpha * left * right; });
    });
}

void add_product(double alpha, const ConstMatrixPart& A, Op op,
                 const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y) {
    with(A, op, [&](const auto& left) { y.noalias() += alpha * left * x; });
}

void multiply_by_lower(double alpha, const ConstMatrixPart& L, MatrixPart B) {
    const Eigen::MatrixXd scaled = alpha * B;
    B.noalias() = L.triangularView<Eigen::Lower>() * scaled;
}

void divide_by_lower(const ConstMatrixPart& L, MatrixPart B) {
    L.triangularView<Eigen::Lower>().solveInPlace(B);
}

void divide_by_transposed(const ConstMatrixPart& L, MatrixPart A) {
    L.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(A);
}

bool take_root(MatrixPart A) {
    return Eigen::LLT<MatrixPart>(A).info() == Eigen::Success;
}

void divide_by_square(const ConstMatrixPart& L, MatrixPart B) {
    divide_by_lower(L, B);
    L.transpose().triangularView<Eigen::Upper>().solveInPlace(B);
}

void invert_square(MatrixPart L) {
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(L.rows(), L.cols());
    divide_by_lower(L, inverse);
    L.triangularView<Eigen::Lower>() = inverse.transpose() * inverse;
}

bool diagonalise(Eigen::MatrixXd& matrix, Eigen::VectorXd& values) {
    if (matrix.size() == 0) {
        values.resize(0);
        return true;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    matrix = solver.eigenvectors();
    values = solver.eigenvalues();
    return solver.info() == Eigen::Success;
}

}  // namespace taut
