// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "adjustment/plan_search.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// Sets all of a plan that follows from its strokes: form, forces, how surely limits are kept, what
/// remains without limits.
void describe_plan(Plan& plan, PlanProblem& problem, const PlanSearch& found);

}  // namespace taut
