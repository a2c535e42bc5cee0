// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"

/// Eigen's decompositions of small dense matrices, each compiled once: a decomposition of Eigen
/// costs 3 to 20 s of compile time in every source that uses it. For large matrices see
/// numerics/dense.hpp.
namespace taut {

/// The X of least Frobenius norm among those that minimise |A X - B|, by a complete orthogonal
/// decomposition: A (m x n) may have any rank. X is n x k for B of m x k.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd minimum_norm_solution(const Eigen::MatrixXd& A,
                                                                     const Eigen::MatrixXd& B);

/// A^-1 B for a square A that may be indefinite or without symmetry, by its LU decomposition.
[[nodiscard]] Eigen::MatrixXd lu_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A^-1 B for a symmetric A that is not singular, by its LDL' decomposition with pivots.
[[nodiscard]] Eigen::MatrixXd symmetric_solution(const Eigen::MatrixXd& A,
                                                 const Eigen::MatrixXd& B);

/// The first n columns of Q in A = Q R (m x n, m >= n): orthonormal.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& A);

/// R in A = Q R (m x n): upper triangular, min(m, n) x n.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& A);

/// The motion (4 x 4, a rotation and a shift) that brings the points `from` (3 x n) nearest to the
/// points `to` in the sum of squared distances, by Umeyama's method.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::Matrix4d rigid_motion(const Eigen::Matrix3Xd& from,
                                                            const Eigen::Matrix3Xd& to);

/// The square roots of the eigenvalues of P P' (3 x 3), ascending: how far points P about their
/// mean (3 x n) spread in three directions across each other.
[[nodiscard]] Eigen::Vector3d spread_of(const Eigen::Matrix3Xd& points);

}  // namespace taut
