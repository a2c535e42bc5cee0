// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/progress.hpp"

namespace taut::gp {

/// `most` of n indices, ascending: a random one of each of as many pieces of the same length; or
/// all. The same at each call.
[[nodiscard]] std::vector<Eigen::Index> spread_part(Eigen::Index n, Eigen::Index most);

/// The least eta that a low rank of n inputs can distinguish from rounding.
[[nodiscard]] double least_noise_ratio(Eigen::Index n);

/// The largest directions of the correlation matrix R of n inputs at one lambda, and the size of
/// the others: docs/theory.md, (nystroem) to (left-out). R is never formed: time is O(n^2 (d + r) +
/// n r^2), memory O(n (d + r)). The same for any number of threads.
/// @param inputs d x n
/// @param rank r, 1 to n: fewer directions result where R has no more above rounding
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT KernelSpectrum
low_rank_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& inputs, double inverse_length_scale,
                  Eigen::Index rank, const Progress& progress = {});

}  // namespace taut::gp
