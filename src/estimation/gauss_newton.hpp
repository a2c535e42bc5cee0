// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearised_statics.hpp"
#include "taut/progress.hpp"

namespace taut {

struct GaussNewtonResult {
    Iterate iterate;
    bool converged = false;
    bool has_factor = true;  ///< that of the statics, as last linearised
    int iterations = 0;
};

/// Gauss-Newton under constraints: from a start to the form and lengths that minimise (map) of
/// docs/theory.md under the statics with the slack set of `statics`, until a step changes no place
/// and no length by more than the tolerance [m]. Each step solves the normal equations (normal);
/// the natural monotonicity test (monotonicity) damps it. Where it converges, the statics are left
/// linearised at the result, to the tolerance.
/// @param progress asked before each step whether to stop; gets no reports
/// @throws Interrupted where a stop was requested
[[nodiscard]] GaussNewtonResult gauss_newton(LinearisedStatics& statics,
                                             const Observations& observations, Iterate start,
                                             double tolerance, int max_iterations,
                                             const Progress& progress = {});

}  // namespace taut
