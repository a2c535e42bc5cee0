// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/gp/fit.hpp"

namespace taut::gp {

/// The weights of the mean's gradient at one input, by eq. mx_*: dm/dx_* = sum_i a_i (x_* - x_i),
///
///     a_i = -lambda^2 w_i k(x_*, x_i)
///
/// of the n training inputs and the m processes (n x m); 0 for a process that is not fitted.
/// @throws std::invalid_argument as FittedProcesses::predict()
[[nodiscard]] Eigen::MatrixXd gradient_weights(const FittedProcesses& fitted,
                                               const Eigen::Ref<const Eigen::VectorXd>& at);

}  // namespace taut::gp
