// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// R b, with the correlation matrix R (n x n) of n inputs, in O(n^2 (d + k)). R is made in blocks
/// of columns that are not kept, so that memory is O(n (d + k)). Parallel; the same for any number
/// of threads.
/// @param inputs d x n
/// @param b n x k
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd correlation_product(
    const Eigen::Ref<const Eigen::MatrixXd>& inputs, double inverse_length_scale,
    const Eigen::MatrixXd& b, const Progress& progress = {});

}  // namespace taut::gp
