// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/observations.hpp"

namespace taut {

/// A fit to perturbed observations.
struct PerturbedFit {
    Iterate iterate;
    double mean_tension = 0.0;          ///< over all cables [N]
    double half_log_determinant = 0.0;  ///< Linearisation::half_log_determinant() there
};

/// From the mean of fits to perturbed observations to that of the posterior.
struct PrestressShift {
    Iterate by;
    double size = 0.0;  ///< of the mean tension, in its standard deviations
};

/// docs/theory.md, (determinant), with covariances over the fits: what weights exp(-l) would do, l
/// half the logarithm of the determinant, along the mean tension. All else that l depends on is
/// noise of so few fits.
/// @return nothing for fewer than 25 fits, and where l does not depend on the mean tension
[[nodiscard]] std::optional<PrestressShift> prestress_shift(const std::vector<PerturbedFit>& fits);

}  // namespace taut
