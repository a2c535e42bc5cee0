// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/dense.hpp"

#include <algorithm>

#include "numerics/blas.hpp"
#include "numerics/parallel.hpp"
#include "numerics/parts.hpp"
#include "numerics/serial_blas.hpp"
#include "taut/numerical_error.hpp"

namespace taut {
namespace {

using Part = Eigen::Ref<const Eigen::MatrixXd>;

/// Columns of a product or a solution that one task computes: independent of the number of threads.
constexpr Eigen::Index columns_of_a_task = 64;

/// Calls work(first column, number of columns) for parts of 0 .. columns, in parallel, with a
/// serial BLAS.
template <class Work>
void for_columns(Eigen::Index columns, const Work& work) {
    const SerialBlas serial;
    const Eigen::Index tasks = (columns + columns_of_a_task - 1) / columns_of_a_task;
    parallel_for(Eigen::Index{0}, tasks, [&](Eigen::Index task) {
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
    if (b.rows() == 0) {
        return forms;
    }
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        const auto x = b.middleCols(first, count);
        Eigen::MatrixXd product = x;
        multiply_by_lower(2.0, triangle, product);
        product.noalias() -= triangle.diagonal().asDiagonal() * x;
        forms.segment(first, count) = product.cwiseProduct(x).colwise().sum().transpose();
    });
    return forms;
}

Cholesky::Cholesky(Eigen::MatrixXd matrix) : m_L(std::move(matrix)) {
    const SerialBlas serial;
    if (!take_root(m_L)) {
        throw NumericalError("the matrix is not positive definite");
    }
}

Eigen::MatrixXd Cholesky::solve(Eigen::MatrixXd b) const {
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        divide_by_square(m_L, b.middleCols(first, count));
    });
    return b;
}

Eigen::MatrixXd Cholesky::solve_lower(Eigen::MatrixXd b) const {
    for_columns(b.cols(), [&](Eigen::Index first, Eigen::Index count) {
        divide_by_lower(m_L, b.middleCols(first, count));
    });
    return b;
}

Eigen::MatrixXd Cholesky::solve_transposed_right(Eigen::MatrixXd b) const {
    const SerialBlas serial;
    by_parts(Parts::parallel, 0, b.rows(), [&](Eigen::Index first, Eigen::Index count) {
        divide_by_transposed(m_L, b.middleRows(first, count));
    });
    return b;
}

Eigen::MatrixXd Cholesky::inverse_lower() const {
    Eigen::MatrixXd inverse = m_L;
    const SerialBlas serial;
    invert_square(inverse);
    return inverse;
}

SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix) {
    if (!matrix.allFinite()) {
        throw NumericalError("eigendecomposition of a matrix that is not finite");
    }
    SymmetricEigen result{.values = {}, .vectors = std::move(matrix)};
    const SerialBlas serial;
    if (!diagonalise(result.vectors, result.values)) {
        throw NumericalError("the eigendecomposition did not converge");
    }
    return result;
}

}  // namespace taut
