// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "numerics/blas.hpp"

/// Products by BLAS on the calling thread, within a SerialBlas. With beta = 0 the result may hold
/// anything before the call.
namespace taut {

enum class Op : char { as_it_is = 'N', transposed = 'T' };

using MatrixPart = Eigen::Ref<Eigen::MatrixXd>;
using ConstMatrixPart = Eigen::Ref<const Eigen::MatrixXd>;

/// C = beta C + alpha op(A) op(B)
inline void multiply(double alpha, const ConstMatrixPart& A, Op op_A, const ConstMatrixPart& B,
                     Op op_B, double beta, MatrixPart C) {
    const auto transpose_A = static_cast<char>(op_A);
    const auto transpose_B = static_cast<char>(op_B);
    const auto rows = static_cast<int>(C.rows());
    const auto columns = static_cast<int>(C.cols());
    const auto inner = static_cast<int>(op_A == Op::as_it_is ? A.cols() : A.rows());
    const auto stride = [](Eigen::Index outer) { return std::max(1, static_cast<int>(outer)); };
    const int stride_of_A = stride(A.outerStride());
    const int stride_of_B = stride(B.outerStride());
    const int stride_of_C = stride(C.outerStride());
    dgemm_(&transpose_A, &transpose_B, &rows, &columns, &inner, &alpha, A.data(), &stride_of_A,
           B.data(), &stride_of_B, &beta, C.data(), &stride_of_C, 1, 1);
}

/// y += alpha op(A) x
inline void add_product(double alpha, const ConstMatrixPart& A, Op op,
                        const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y) {
    if (A.size() == 0) {
        return;
    }
    const auto transpose = static_cast<char>(op);
    const auto rows = static_cast<int>(A.rows());
    const auto columns = static_cast<int>(A.cols());
    const auto stride = static_cast<int>(A.outerStride());
    const int one = 1;
    const double beta = 1.0;
    dgemv_(&transpose, &rows, &columns, &alpha, A.data(), &stride, x.data(), &one, &beta, y.data(),
           &one, 1);
}

}  // namespace taut
