// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "estimation/drawn_posterior.hpp"
#include "estimation/observations.hpp"
#include "taut/progress.hpp"

namespace taut {

/// Observations and priors to which perturbed fits have the mean that weights would give them.
struct ShiftedSites {
    Observations sites;
    /// By how much the estimates of the lengths must move, too (m_I); empty: not at all [m].
    Eigen::VectorXd length_shift;
};

/// Moves all that is observed and assumed by docs/theory.md (determinant), which takes some 40 fits
/// besides the draws; twice that where the mean tension moves by more than a standard deviation.
/// @param by_fits as of fit_perturbed()
/// @throws Interrupted
[[nodiscard]] ShiftedSites shifted_by_determinant(const DrawnPosterior& posterior, bool by_fits,
                                                  const Progress& progress);

}  // namespace taut
