// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adjustment/stroke_search.hpp"

namespace taut {

/// Which strokes are fixed next: a quarter of those that are open, at least 8 where there are so
/// many, those that their multiples are nearest to.
/// @param open indices of strokes
/// @param multiples of each stroke, whole steps within its limits [m]
[[nodiscard]] std::vector<int> next_to_fix(std::vector<int> open, const Eigen::VectorXd& strokes,
                                           const Eigen::VectorXd& multiples);

/// Brings strokes to whole multiples of a step within their limits: those nearest to one are fixed
/// first and the others sought anew, a quarter at a time; then single steps either way as long as
/// one helps. Exact equilibrium after each. docs/theory.md (whole-steps).
[[nodiscard]] StrokedState in_whole_steps(std::vector<LimitedResponse>& responses,
                                          const StrokeTask& task, const StrokedState& free,
                                          double step);

}  // namespace taut
