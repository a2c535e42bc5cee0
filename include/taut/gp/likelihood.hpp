// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/gp/kernel.hpp"
#include "taut/gp/spectrum.hpp"

namespace taut::gp {

/// The negative log marginal likelihood of one output, and its gradient.
struct Likelihood {
    double value = 0.0;        ///< negative log marginal likelihood
    Eigen::Vector3d gradient;  ///< with respect to log lambda, log sigma_f, log sigma_w
};

/// The negative log marginal likelihood of one output (eq. max_marginal_likelihood) with zero mean,
///
///     1/2 y' C^-1 y + 1/2 log det C + n/2 log 2 pi,   C = sigma_f^2 R + sigma_w^2 I,
///
/// and its gradient, 1/2 tr(C^-1 dC) - 1/2 a' dC a with a = C^-1 y (Rasmussen and Williams,
/// eq. 5.9). That sizes agree is not checked.
/// @param spectrum of the correlation matrix R at hyperparameters.inverse_length_scale, whole
/// @param squared_distances of all pairs of training inputs (n x n)
/// @param output y (n)
[[nodiscard]] TAUT_CORE_EXPORT Likelihood negative_log_likelihood(
    const KernelSpectrum& spectrum, const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
    const Eigen::Ref<const Eigen::VectorXd>& output, const Hyperparameters& hyperparameters);

/// Bounds of the noise ratio eta = sigma_w^2 / sigma_f^2 in which it is estimated.
struct NoiseRatioBounds {
    double lower;        ///< above 0
    double upper = 1e3;  ///< not below `lower`
};

/// The lower bound keeps R + eta I away from singular: ten times the rounding error of an
/// eigenvalue of R, whose largest is at most n.
[[nodiscard]] TAUT_CORE_EXPORT NoiseRatioBounds default_noise_ratio_bounds(Eigen::Index n);

}  // namespace taut::gp
