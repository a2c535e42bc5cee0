// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// The indices of `most` of n, ascending, one at random of each of as many pieces of the same
/// length; or of all. The same at each call.
[[nodiscard]] std::vector<Eigen::Index> spread_part(Eigen::Index n, Eigen::Index most);

/// Least eta that a low rank of n inputs can tell from rounding.
[[nodiscard]] double least_noise_ratio(Eigen::Index n);

/// The directions of the correlation matrix R of n inputs that count at one lambda, and how large
/// the others are: docs/theory.md, (nystroem) to (left-out). R is never formed: time is
/// O(n^2 (d + r) + n r^2), memory O(n (d + r)). The same for any number of threads.
/// @param inputs d x n
/// @param rank r, 1 to n: fewer directions come where R has no more beyond rounding
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT KernelSpectrum
low_rank_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& inputs, double inverse_length_scale,
                  Eigen::Index rank, const Progress& progress = {});

}  // namespace taut::gp
