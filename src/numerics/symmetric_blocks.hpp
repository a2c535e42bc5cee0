// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace taut {

/// Symmetric matrices of 3 x 3, one a node: their diagonals (3 x n), and their entries xy, xz and
/// yz (3 x n; 3 x 0: all 0).

[[nodiscard]] inline Eigen::Matrix3d symmetric_block(const Eigen::Matrix3Xd& diagonals,
                                                     const Eigen::Matrix3Xd& crosses, int node) {
    Eigen::Matrix3d result = diagonals.col(node).asDiagonal();
    if (crosses.cols() > 0) {
        result(0, 1) = result(1, 0) = crosses(0, node);
        result(0, 2) = result(2, 0) = crosses(1, node);
        result(1, 2) = result(2, 1) = crosses(2, node);
    }
    return result;
}

/// Each times its vector (3 x n).
[[nodiscard]] inline Eigen::Matrix3Xd symmetric_products(const Eigen::Matrix3Xd& diagonals,
                                                         const Eigen::Matrix3Xd& crosses,
                                                         const Eigen::Matrix3Xd& vectors) {
    Eigen::Matrix3Xd result = diagonals.cwiseProduct(vectors);
    if (crosses.cols() > 0) {
        const auto xy = crosses.row(0).array();
        const auto xz = crosses.row(1).array();
        const auto yz = crosses.row(2).array();
        const auto x = vectors.row(0).array();
        const auto y = vectors.row(1).array();
        const auto z = vectors.row(2).array();
        result.row(0).array() += xy * y + xz * z;
        result.row(1).array() += xy * x + yz * z;
        result.row(2).array() += xz * x + yz * y;
    }
    return result;
}

}  // namespace taut
