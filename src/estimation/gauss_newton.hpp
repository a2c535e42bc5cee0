// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/linearisation.hpp"
#include "taut/progress.hpp"

namespace taut {

struct GaussNewtonResult {
    Iterate iterate;
    bool converged = false;
    /// The last one: where it converged at the result, to the tolerance; nothing without a factor.
    std::optional<Linearisation> linearisation;
};

/// Gauss-Newton under constraints: from a start to the form and lengths that minimise (map) of
/// docs/theory.md under the statics of a model, until a step changes no place and no length by
/// more than the tolerance [m]. Each step solves the normal equations (normal); the natural
/// monotonicity test (monotonicity) damps it.
/// @param progress asked before each step whether to stop; gets no reports
/// @param before as of linearise(), of which `model` is no part
/// @throws Interrupted where a stop was requested
[[nodiscard]] GaussNewtonResult gauss_newton(const StaticsModel& model,
                                             const Observations& observations, Iterate start,
                                             double tolerance, int max_iterations,
                                             const Progress& progress = {},
                                             std::optional<Linearisation> before = std::nullopt);

}  // namespace taut
