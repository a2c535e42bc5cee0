// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

/// The routines of BLAS and LAPACK that taut calls, on the calling thread, within a SerialBlas.
/// They are those of a library (blas_library.cpp), or, where taut was built without one
/// (TAUT_WITH_BLAS), Eigen's (blas_eigen.cpp). With beta = 0 the result may hold anything before
/// the call. Of L and of symmetric matrices the lower triangle is read.
namespace taut {

enum class Op : char { as_it_is = 'N', transposed = 'T' };

using MatrixPart = Eigen::Ref<Eigen::MatrixXd>;
using ConstMatrixPart = Eigen::Ref<const Eigen::MatrixXd>;

/// C = beta C + alpha op(A) op(B)
void multiply(double alpha, const ConstMatrixPart& A, Op op_A, const ConstMatrixPart& B, Op op_B,
              double beta, MatrixPart C);

/// y += alpha op(A) x
void add_product(double alpha, const ConstMatrixPart& A, Op op,
                 const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y);

/// B becomes alpha L B.
void multiply_by_lower(double alpha, const ConstMatrixPart& L, MatrixPart B);

/// B becomes L^-1 B.
void divide_by_lower(const ConstMatrixPart& L, MatrixPart B);

/// A becomes A L^-T.
void divide_by_transposed(const ConstMatrixPart& L, MatrixPart A);

/// L of L L' = A in place of its lower triangle.
/// @return whether A is positive definite
[[nodiscard]] bool take_root(MatrixPart A);

/// B becomes (L L')^-1 B.
void divide_by_square(const ConstMatrixPart& L, MatrixPart B);

/// The lower triangle of (L L')^-1 in place of L.
void invert_square(MatrixPart L);

/// Eigenvectors in place of a symmetric matrix, and its eigenvalues in ascending order.
/// @return whether they were found
[[nodiscard]] bool diagonalise(Eigen::MatrixXd& matrix, Eigen::VectorXd& values);

}  // namespace taut
