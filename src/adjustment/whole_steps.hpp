// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adjustment/stroke_search.hpp"

namespace taut {

/// The strokes to fix next: the quarter of the open ones, at least 8, that are nearest to their
/// multiples.
/// @param open indices of strokes
/// @param multiples of each stroke, whole steps within its limits [m]
[[nodiscard]] std::vector<int> next_to_fix(std::vector<int> open, const Eigen::VectorXd& strokes,
                                           const Eigen::VectorXd& multiples);

/// Rounds strokes to whole multiples of a step within their limits. A quarter at a time, those
/// nearest to a multiple are fixed and the others searched anew; then single strokes move by a step
/// while one helps. Exact equilibrium after each. docs/theory.md (whole-steps).
[[nodiscard]] StrokedState in_whole_steps(std::vector<LimitedResponse>& responses,
                                          const StrokeTask& task, const StrokedState& free,
                                          double step);

}  // namespace taut
