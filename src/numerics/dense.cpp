// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/dense.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "numerics/blas.hpp"
#include "numerics/parts.hpp"
#include "numerics/products.hpp"
#include "numerics/serial_blas.hpp"
#include "taut/numerical_error.hpp"

namespace taut {
namespace {

constexpr char transposed = 'T';
constexpr char as_it_is = 'N';
constexpr char lower = 'L';
constexpr char left = 'L';
constexpr char right = 'R';
constexpr char not_unit = 'N';

using Part = Eigen::Ref<const Eigen::MatrixXd>;

int size_of(Eigen::Index index) {
    return static_cast<int>(index);
}

/// Columns of a product or a solution that one task computes: independent of the number of threads.
constexpr Eigen::Index columns_of_a_task = 64;

/// Calls work(first column, number of columns) for parts of 0 .. columns, in parallel, with a
/// serial BLAS.
template <class Work>
void for_columns(Eigen::Index columns, const Work& work) {
    const SerialBlas serial;
    const Eigen::Index tasks = (columns + columns_of_a_task - 1) / columns_of_a_task;
    tbb::parallel_for(Eigen::Index{0}, tasks, [&](Eigen::Index task) {
        const Eigen::Index first = task * columns_of_a_task;
        work(first, std::min(columns_of_a_task, columns - first));
    });
}

Eigen::MatrixXd multiply(Op op_a, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    Eigen::MatrixXd c(op_a == Op::transposed ? a.cols() : a.rows(), b.cols());
    if (c.size() == 0 || b.rows() == 0) {
        return c.setZero();
    }
    for_columns(c.cols(), [&](Eigen::Index first, Eigen::Index count) {
        multiply(1.0, a, op_a, b.middleCols(first, count), Op::as_it_is, 0.0,
                 c.middleCols(first, count));
    });
    return c;
}

/// Products of fewer multiplications are faster without BLAS.
constexpr double small_product = 16384.0;

bool is_small(Eigen::Index rows, Eigen::Index columns, Eigen::Index inner) {
    return static_cast<double>(rows) * static_cast<double>(columns) * static_cast<double>(inner) <
           small_product;
}

}  // namespace

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return multiply(Op::as_it_is, a, b);
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return multiply(Op::transposed, a, b);
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& a) {
    Eigen::MatrixXd c(a.cols(), a.cols());
    if (a.rows() == 0) {
        return c.setZero();
    }
    for_columns(c.cols(), [&](Eigen::Index first, Eigen::Index count) {
        const Eigen::Index rows = c.rows() - first;
        multiply(1.0, a.rightCols(rows), Op::transposed, a.middleCols(first, count), Op::as_it_is,
                 0.0, c.block(first, first, rows, count));
    });
    c.triangularView<Eigen::StrictlyUpper>() = c.transpose();
    return c;
}

void add_product(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a, const Part& b) {
    if (is_small(c.rows(), c.cols(), a.cols())) {
        c.noalias() += factor * a * b;
    } else {
        multiply(factor, a, Op::as_it_is, b, Op::as_it_is, 1.0, c);
    }
}

void add_product_transposed(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a,
                            const Part& b) {
    if (is_small(c.rows(), c.cols(), a.cols())) {
        c.noalias() += factor * a * b.transpose();
    } else {
        multiply(factor, a, Op::as_it_is, b, Op::transposed, 1.0, c);
    }
}

void add_transposed_product(Eigen::Ref<Eigen::MatrixXd> c, double factor, const Part& a,
                            const Part& b) {
    if (is_small(c.rows(), c.cols(), a.rows())) {
        c.noalias() += factor * a.transpose() * b;
    } else {
        multiply(factor, a, Op::transposed, b, Op::as_it_is, 1.0, c);
    }
}

Eigen::VectorXd quadratic_forms(const Eigen::MatrixXd& triangle, const Eigen::MatrixXd& b) {
    // x'Ax = 2 x'Lx - sum_i A_ii x_i^2 with the lower triangle L: half the work of A b.
    Eigen::VectorXd forms = Eigen::VectorXd::Zero(b.cols());
    const int n = size_of(b.rows());
    if (n == 0) {
        return forms;
    }
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        const auto x = b.middleCols(first, count);
        Eigen::MatrixXd product = x;
        const int columns = size_of(count);
        constexpr double two = 2.0;
        dtrmm_(&left, &lower, &as_it_is, &not_unit, &n, &columns, &two, triangle.data(), &n,
               product.data(), &n, 1, 1, 1, 1);
        product.noalias() -= triangle.diagonal().asDiagonal() * x;
        forms.segment(first, count) = product.cwiseProduct(x).colwise().sum().transpose();
    });
    return forms;
}

Cholesky::Cholesky(Eigen::MatrixXd matrix) : m_L(std::move(matrix)) {
    const int n = size_of(m_L.rows());
    const int lda = std::max(1, n);
    int info = 0;
    const SerialBlas serial;
    dpotrf_(&lower, &n, m_L.data(), &lda, &info, 1);
    if (info != 0) {
        throw NumericalError(fmt::format("the matrix is not positive definite (dpotrf: {})", info));
    }
}

Eigen::MatrixXd Cholesky::solve(Eigen::MatrixXd b) const {
    const int n = size_of(m_L.rows());
    const int lda = std::max(1, n);
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        const int columns = size_of(count);
        int info = 0;
        dpotrs_(&lower, &n, &columns, m_L.data(), &lda, b.col(first).data(), &lda, &info, 1);
    });
    return b;
}

Eigen::MatrixXd Cholesky::solve_lower(Eigen::MatrixXd b) const {
    const int n = size_of(m_L.rows());
    const int lda = std::max(1, n);
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        const int columns = size_of(count);
        constexpr double one = 1.0;
        dtrsm_(&left, &lower, &as_it_is, &not_unit, &n, &columns, &one, m_L.data(), &lda,
               b.col(first).data(), &lda, 1, 1, 1, 1);
    });
    return b;
}

Eigen::MatrixXd Cholesky::solve_transposed_right(Eigen::MatrixXd b) const {
    const int n = size_of(m_L.rows());
    const int lda = std::max(1, n);
    const int ldb = std::max(1, size_of(b.rows()));
    const SerialBlas serial;
    by_parts(Parts::parallel, 0, b.rows(), [&](Eigen::Index first, Eigen::Index count) {
        const int rows = size_of(count);
        constexpr double one = 1.0;
        dtrsm_(&right, &lower, &transposed, &not_unit, &rows, &n, &one, m_L.data(), &lda,
               b.data() + first, &ldb, 1, 1, 1, 1);
    });
    return b;
}

Eigen::MatrixXd Cholesky::inverse_lower() const {
    Eigen::MatrixXd inverse = m_L;
    const int n = size_of(m_L.rows());
    const int lda = std::max(1, n);
    int info = 0;
    const SerialBlas serial;
    dpotri_(&lower, &n, inverse.data(), &lda, &info, 1);
    return inverse;
}

SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix) {
    SymmetricEigen result;
    const int n = size_of(matrix.rows());
    if (!matrix.allFinite()) {
        throw NumericalError("eigendecomposition of a matrix that is not finite");
    }
    result.values.resize(n);
    const int lda = std::max(1, n);
    int info = 0;
    double work_size = 0.0;
    int integer_work_size = 0;
    constexpr int ask = -1;
    const SerialBlas serial;
    dsyevd_("V", &lower, &n, matrix.data(), &lda, result.values.data(), &work_size, &ask,
            &integer_work_size, &ask, &info, 1, 1);
    // Some versions return a size that was rounded on its way through a double.
    const int size = size_of(static_cast<Eigen::Index>(work_size) + 1);
    Eigen::VectorXd work(size);
    Eigen::VectorXi integer_work(std::max(1, integer_work_size));
    const int integer_size = size_of(integer_work.size());
    dsyevd_("V", &lower, &n, matrix.data(), &lda, result.values.data(), work.data(), &size,
            integer_work.data(), &integer_size, &info, 1, 1);
    if (info != 0) {
        throw NumericalError(fmt::format("eigendecomposition failed (dsyevd: {})", info));
    }
    result.vectors = std::move(matrix);
    return result;
}

}  // namespace taut
