// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/gp/likelihood.hpp"

namespace taut::gp {

/// The profile of the likelihood at one lambda: the best values of each of m outputs.
struct LikelihoodProfile {
    Eigen::VectorXd value;        ///< smallest negative log likelihood over sigma_f, sigma_w (m)
    Eigen::VectorXd slope;        ///< its derivative with respect to log lambda (m), or empty
    Eigen::VectorXd noise_ratio;  ///< eta = sigma_w^2 / sigma_f^2 there (m)
    Eigen::VectorXd signal_variance;  ///< sigma_f^2 there (m)
};

/// Whether to compute the slope of a profile, which takes as long as all the rest.
enum class Slope { wanted, left_out };

/// Minimises the negative log likelihood of every output over sigma_f and sigma_w, at one lambda.
/// For a given eta the best sigma_f^2 is (1/n) sum_i z_i^2 / (d_i + eta), z = Q'y. What remains is
/// a function of eta alone:
///
///     n/2 log sigma_f^2 + 1/2 sum_i log(d_i + eta) + n/2 (1 + log 2 pi)
///
/// Where a spectrum is not whole, the other n - r terms have the mean of its tail for d_i, and the
/// rest of |y|^2 for the sum of their z_i^2; there is no slope then.
/// That sizes agree, and 0 < bounds.lower <= bounds.upper, is not checked.
/// @param squared_distances of all pairs of training inputs (n x n); only the slope needs them
/// @param outputs n x m, none of them zero throughout
[[nodiscard]] TAUT_CORE_EXPORT LikelihoodProfile profile_likelihood(
    const KernelSpectrum& spectrum, const Eigen::Ref<const Eigen::MatrixXd>& squared_distances,
    const Eigen::Ref<const Eigen::MatrixXd>& outputs, const NoiseRatioBounds& bounds,
    Slope slope = Slope::wanted);

}  // namespace taut::gp
