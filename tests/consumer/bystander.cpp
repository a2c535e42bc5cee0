// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <Eigen/Dense>

/// The norm of a matrix that is made, grown and freed here.
double bystander_norm(int size) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
    matrix.conservativeResize(2 * size, 2 * size);
    matrix.setIdentity();
    return matrix.norm();
}
