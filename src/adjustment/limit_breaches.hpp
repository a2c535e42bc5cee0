// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "adjustment/plan_problem.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// Each limit as given that is broken in the estimate, or kept with less than a probability. Those
/// that the estimate breaks come first, the worst of each first.
/// @param draws of the state; null: none
[[nodiscard]] std::vector<LimitBreach> limit_breaches(const PlanProblem& problem,
                                                      const StrokedState& state,
                                                      const DrawnStrokes* draws,
                                                      double least_probability);

}  // namespace taut
