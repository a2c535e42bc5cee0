// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// (R + eta_j I)^-1 y_j of each output, by a spectrum of R. If it is not whole, the mean of its
/// tail stands for all that it leaves out.
/// @param outputs n x k
/// @param noise_ratios eta (k), positive
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd weights_by_spectrum(
    const KernelSpectrum& spectrum, const Eigen::MatrixXd& outputs,
    const Eigen::VectorXd& noise_ratios);

struct RefinedWeights {
    Eigen::MatrixXd weights;    ///< n x k
    Eigen::VectorXd residuals;  ///< of y - (R + eta I) w, root mean square (k)
};

/// Weights that are closer to those of R itself: a few steps of conjugate gradients from those by
/// the spectrum, docs/theory.md (refined-weights).
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT RefinedWeights
refined_weights(const Eigen::Ref<const Eigen::MatrixXd>& inputs, const KernelSpectrum& spectrum,
                const Eigen::MatrixXd& outputs, const Eigen::VectorXd& noise_ratios,
                const Eigen::VectorXd& tolerances, const Progress& progress = {});

}  // namespace taut::gp
