// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/dense.hpp"

#include <cblas.h>
#include <fmt/core.h>
#include <lapacke.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace taut {
namespace {

Eigen::MatrixXd multiply(CBLAS_TRANSPOSE transpose, const Eigen::MatrixXd& a,
                         const Eigen::MatrixXd& b) {
    const Eigen::Index rows = transpose == CblasTrans ? a.cols() : a.rows();
    const Eigen::Index inner = transpose == CblasTrans ? a.rows() : a.cols();
    Eigen::MatrixXd c(rows, b.cols());
    if (c.size() == 0 || inner == 0) {
        return c.setZero();
    }
    cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, static_cast<int>(rows),
                static_cast<int>(b.cols()), static_cast<int>(inner), 1.0, a.data(),
                static_cast<int>(a.rows()), b.data(), static_cast<int>(b.rows()), 0.0, c.data(),
                static_cast<int>(rows));
    return c;
}

/// How many SerialBlas live, and the threads of BLAS before the first of them.
std::mutex serial_mutex;
int serial_count = 0;
int threads_before = 1;

/// Fewer multiplications than these are faster without a call to BLAS.
constexpr double small_product = 16384.0;

bool is_small(Eigen::Index rows, Eigen::Index columns, Eigen::Index inner) {
    return static_cast<double>(rows) * static_cast<double>(columns) * static_cast<double>(inner) <
           small_product;
}

using Part = Eigen::Ref<const Eigen::MatrixXd>;

void add(Eigen::Ref<Eigen::MatrixXd>& c, double factor, CBLAS_TRANSPOSE transpose_a, const Part& a,
         CBLAS_TRANSPOSE transpose_b, const Part& b) {
    const Eigen::Index inner = transpose_a == CblasTrans ? a.rows() : a.cols();
    cblas_dgemm(CblasColMajor, transpose_a, transpose_b, static_cast<int>(c.rows()),
                static_cast<int>(c.cols()), static_cast<int>(inner), factor, a.data(),
                static_cast<int>(a.outerStride()), b.data(), static_cast<int>(b.outerStride()), 1.0,
                c.data(), static_cast<int>(c.outerStride()));
}

}  // namespace

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return multiply(CblasNoTrans, a, b);
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return multiply(CblasTrans, a, b);
}

SerialBlas::SerialBlas() {
    const std::scoped_lock lock(serial_mutex);
    if (serial_count++ == 0) {
        threads_before = openblas_get_num_threads();
        openblas_set_num_threads(1);
    }
}

SerialBlas::~SerialBlas() {
    const std::scoped_lock lock(serial_mutex);
    if (--serial_count == 0) {
        openblas_set_num_threads(threads_before);
    }
}

void add_product(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a, const Part& b) {
    if (is_small(c.rows(), c.cols(), a.cols())) {
        c.noalias() += factor * a * b;
    } else {
        add(c, factor, CblasNoTrans, a, CblasNoTrans, b);
    }
}

void add_product_transposed(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a,
                            const Part& b) {
    if (is_small(c.rows(), c.cols(), a.cols())) {
        c.noalias() += factor * a * b.transpose();
    } else {
        add(c, factor, CblasNoTrans, a, CblasTrans, b);
    }
}

void add_transposed_product(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a,
                            const Part& b) {
    if (is_small(c.rows(), c.cols(), a.rows())) {
        c.noalias() += factor * a.transpose() * b;
    } else {
        add(c, factor, CblasTrans, a, CblasNoTrans, b);
    }
}

Eigen::VectorXd quadratic_forms(const Eigen::MatrixXd& lower, const Eigen::MatrixXd& b) {
    // x'Ax = 2 x'Lx - sum_i A_ii x_i^2 with the lower triangle L: half the work of A b.
    Eigen::MatrixXd product = b;
    if (product.size() > 0) {
        cblas_dtrmm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit,
                    static_cast<int>(b.rows()), static_cast<int>(b.cols()), 2.0, lower.data(),
                    static_cast<int>(lower.rows()), product.data(), static_cast<int>(b.rows()));
    }
    product.noalias() -= lower.diagonal().asDiagonal() * b;
    return product.cwiseProduct(b).colwise().sum().transpose();
}

Cholesky::Cholesky(Eigen::MatrixXd matrix) : m_L(std::move(matrix)) {
    const auto n = static_cast<lapack_int>(m_L.rows());
    const lapack_int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, m_L.data(), std::max(1, n));
    if (info != 0) {
        throw std::runtime_error(
            fmt::format("the matrix is not positive definite (dpotrf: {})", info));
    }
}

Eigen::MatrixXd Cholesky::solve(Eigen::MatrixXd b) const {
    const auto n = static_cast<lapack_int>(m_L.rows());
    LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'L', n, static_cast<lapack_int>(b.cols()), m_L.data(),
                   std::max(1, n), b.data(), std::max(1, n));
    return b;
}

Eigen::MatrixXd Cholesky::solve_lower(Eigen::MatrixXd b) const {
    const auto n = static_cast<int>(m_L.rows());
    if (b.size() > 0) {
        cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n,
                    static_cast<int>(b.cols()), 1.0, m_L.data(), n, b.data(), n);
    }
    return b;
}

Eigen::MatrixXd Cholesky::inverse_lower() const {
    Eigen::MatrixXd inverse = m_L;
    const auto n = static_cast<lapack_int>(m_L.rows());
    LAPACKE_dpotri(LAPACK_COL_MAJOR, 'L', n, inverse.data(), std::max(1, n));
    return inverse;
}

SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix) {
    SymmetricEigen result;
    const auto n = static_cast<lapack_int>(matrix.rows());
    result.values.resize(n);
    const lapack_int info =
        LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', n, matrix.data(), n, result.values.data());
    if (info != 0) {
        throw std::runtime_error(fmt::format("eigendecomposition failed (dsyevd: {})", info));
    }
    result.vectors = std::move(matrix);
    return result;
}

}  // namespace taut
