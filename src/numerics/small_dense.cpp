// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/small_dense.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace taut {

Eigen::MatrixXd minimum_norm_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    return A.completeOrthogonalDecomposition().solve(B);
}

Eigen::MatrixXd lu_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    return A.partialPivLu().solve(B);
}

Eigen::MatrixXd symmetric_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    return A.ldlt().solve(B);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& A) {
    return A.householderQr().householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.cols());
}

Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& A) {
    return A.householderQr()
        .matrixQR()
        .topRows(std::min(A.rows(), A.cols()))
        .triangularView<Eigen::Upper>();
}

Eigen::Matrix4d rigid_motion(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    return Eigen::umeyama(from, to, false);
}

Eigen::Vector3d spread_of(const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        squares += points.col(i) * points.col(i).transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .cwiseMax(0.0)
        .cwiseSqrt();
}

}  // namespace taut
