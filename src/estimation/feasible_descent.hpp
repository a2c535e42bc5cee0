// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/gauss_newton.hpp"

namespace taut {

/// Enough where many edges may be slack: hypar:40x40 with lengths uniform:1mm needs some 100.
inline constexpr int most_descents = 200;

/// The search for cases where gauss_newton() does not converge: damped steps (K. Levenberg 1944, D.
/// Marquardt 1963) from one form and lengths in equilibrium to the next, each of which lowers the
/// objective of docs/theory.md (map):
///
///   F(r, d) = 1/2 sum (y - r)' Sigma^-1 (y - r) + 1/2 sum (d - mean)^2 / variance.
///
/// A step solves (damped); projections then restore the balance, (projection). It converges where
/// the undamped step is shorter than `small_decrement` posterior standard deviations, all
/// directions together, (decrement).
/// @param start near equilibrium under the model
/// @param max_iterations linearisations
/// @param progress asked before each step whether to stop; gets no reports
/// @param before as of linearise(), of which `model` is no part
/// @throws Interrupted where a stop was requested
[[nodiscard]] GaussNewtonResult feasible_descent(
    const StaticsModel& model, const Observations& observations, Iterate start,
    double small_decrement, int max_iterations, const Progress& progress = {},
    std::optional<Linearisation> before = std::nullopt);

}  // namespace taut
