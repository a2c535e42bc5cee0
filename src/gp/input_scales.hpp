// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// Sum over m outputs of the smallest negative log marginal likelihood (each output's own sigma_f
/// and sigma_w at their best), and its gradient with respect to the logarithms of the groups'
/// scales.
struct ScalesLikelihood {
    double value = 0.0;        ///< the sum; the smaller, the likelier
    Eigen::VectorXd gradient;  ///< one per group (G)
};

/// The likelihood with the squared exponential kernel that scales each input dimension (eq.
/// SEkernel),
///
///     exp(-1/2 sum_i (s_g(i) (x_i - x'_i))^2),  g(i) the group of dimension i
///
/// That sizes and groups agree is not checked.
/// @param inputs d x n
/// @param outputs n x m, none of them constant
/// @param groups of the d dimensions, 0 to G - 1
/// @param log_scales of the G groups
/// @throws std::invalid_argument for a scale or an input that is not finite
[[nodiscard]] TAUT_CORE_EXPORT ScalesLikelihood
scales_likelihood(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                  const Eigen::Ref<const Eigen::MatrixXd>& outputs, const std::vector<int>& groups,
                  const Eigen::Ref<const Eigen::VectorXd>& log_scales);

/// Automatic relevance determination for many outputs at once: the scale of each input dimension
/// (d), relative to their geometric mean, that makes all outputs together most likely. Dimensions
/// of one group share a scale. With the inputs so scaled, fit() estimates each output's own
/// lambda, so that lambda_i of eq. SEkernel is that lambda times the dimension's scale. Where there
/// are more than 500 inputs, 500 of them are used.
/// @param progress gets the stage "scales of the kernel" before each evaluation of the
///   likelihood
/// @throws std::invalid_argument as fit(), and for groups that are not one per dimension, from 0 on
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd estimate_input_scales(
    const Eigen::Ref<const Eigen::MatrixXd>& inputs,
    const Eigen::Ref<const Eigen::MatrixXd>& outputs, const std::vector<int>& groups,
    const Progress& progress = {});

}  // namespace taut::gp
