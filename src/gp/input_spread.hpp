// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace taut::gp {

/// Distances of the training inputs, without those that are the same.
struct InputSpread {
    double distance = 0.0;             ///< median of all pairs; 0 if all inputs are the same
    double distance_to_nearest = 0.0;  ///< median over the inputs
};

/// @param inputs d x n
/// @param squared_distances of all pairs of them (n x n)
[[nodiscard]] InputSpread input_spread(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                       const Eigen::MatrixXd& squared_distances);

}  // namespace taut::gp
