// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"

/// The dense operations for which taut uses BLAS and LAPACK. All except add_product and the two
/// like it run in parallel by oneTBB over parts of the columns, each task with a serial BLAS: the
/// results do not depend on the number of threads.
namespace taut {

/// a * b
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// a' * b
[[nodiscard]] Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                                 const Eigen::MatrixXd& b);

/// a' * a, by half the work of transposed_product(a, a)
[[nodiscard]] Eigen::MatrixXd gram(const Eigen::MatrixXd& a);

/// c += factor * a * b. This and the next two run on the calling thread, within a SerialBlas.
void add_product(Eigen::Ref<Eigen::MatrixXd> c, double factor,
                 const Eigen::Ref<const Eigen::MatrixXd>& a,
                 const Eigen::Ref<const Eigen::MatrixXd>& b);

/// c += factor * a * b'
void add_product_transposed(Eigen::Ref<Eigen::MatrixXd> c, double factor,
                            const Eigen::Ref<const Eigen::MatrixXd>& a,
                            const Eigen::Ref<const Eigen::MatrixXd>& b);

/// c += factor * a' * b
void add_transposed_product(Eigen::Ref<Eigen::MatrixXd> c, double factor,
                            const Eigen::Ref<const Eigen::MatrixXd>& a,
                            const Eigen::Ref<const Eigen::MatrixXd>& b);

/// x' A x of every column x of b (n x k), for a symmetric A (n x n). Reads the lower triangle of A.
[[nodiscard]] Eigen::VectorXd quadratic_forms(const Eigen::MatrixXd& triangle,
                                              const Eigen::MatrixXd& b);

/// The factor L of a symmetric, positive definite matrix L L'.
class Cholesky {
public:
    /// Reads the lower triangle of the matrix.
    /// @throws NumericalError if the matrix is not positive definite
    explicit Cholesky(Eigen::MatrixXd matrix);

    /// (L L')^-1 b
    [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd b) const;
    /// L^-1 b
    [[nodiscard]] Eigen::MatrixXd solve_lower(Eigen::MatrixXd b) const;
    /// b L'^-1
    [[nodiscard]] Eigen::MatrixXd solve_transposed_right(Eigen::MatrixXd b) const;
    /// (L L')^-1, its lower triangle
    [[nodiscard]] Eigen::MatrixXd inverse_lower() const;

private:
    Eigen::MatrixXd m_L;
};

struct SymmetricEigen {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< columns, orthonormal
};

/// All eigenvalues and eigenvectors of a symmetric matrix.
/// @throws NumericalError if an entry is not finite or LAPACK does not converge
[[nodiscard]] TAUT_CORE_EXPORT SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix);

}  // namespace taut
