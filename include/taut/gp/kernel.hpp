// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

/// Gaussian process regression of many outputs over the same inputs. Inputs are columns: n training
/// inputs of dimension d are a d x n matrix; the m outputs at them are an n x m matrix.
namespace taut::gp {

/// Hyperparameters of one process: theta of the paper (section 2.3) and the noise.
struct Hyperparameters {
    double inverse_length_scale = 0.0;  ///< lambda, in 1 / unit of the inputs
    double signal_std = 0.0;            ///< sigma_f, in the unit of the output
    double noise_std = 0.0;             ///< sigma_w, in the unit of the output
};

/// |x_i - z_j|^2 of all pairs of columns of x (d x n) and z (d x k): n x k, never negative. That
/// both have d rows is not checked.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd squared_distances(
    const Eigen::Ref<const Eigen::MatrixXd>& x, const Eigen::Ref<const Eigen::MatrixXd>& z);

/// squared_distances(x, x), by half the work.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd squared_distances(
    const Eigen::Ref<const Eigen::MatrixXd>& x);

/// The isotropic squared exponential kernel with signal std 1 (eq. SEkernel_iso):
/// exp(-lambda^2 / 2 |x - x'|^2), entry by entry of the squared distances.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd correlation(
    const Eigen::Ref<const Eigen::MatrixXd>& squared_distances, double inverse_length_scale);

}  // namespace taut::gp
