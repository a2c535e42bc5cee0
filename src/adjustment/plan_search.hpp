// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "adjustment/plan_problem.hpp"
#include "adjustment/stroke_search.hpp"

namespace taut {

/// Strokes, and what they were searched for.
struct PlanSearch {
    StrokeSearch search;
    StrokeTask task;
    std::vector<ForceRange> effective;  ///< limits: the given ones, perhaps narrowed
};

/// The best form within the limits as given; where they cannot be kept, the least violation.
[[nodiscard]] PlanSearch search_of_estimate(PlanProblem& problem);

/// Moves the target tensions by how far the mean of the samples is from the estimate, so that the
/// mean comes to the targets as given. That difference depends little on the strokes, so both are
/// found in turn.
[[nodiscard]] PlanSearch aimed_at_mean(PlanProblem& problem, PlanSearch found);

/// Narrows the limits until the given ones are kept with the required probability,
/// docs/theory.md (limit-margins). The margin depends on the plan, so both are found in turn.
[[nodiscard]] PlanSearch with_margins(PlanProblem& problem, PlanSearch found);

/// Turns the fewest edges with which the plan is within PlanOptions::tolerance, and none of the
/// others from then on, (fewest-strokes). As it was where it is not within.
/// @param bound gets Plan::fewest_bound
[[nodiscard]] PlanSearch turning_fewest(PlanProblem& problem, PlanSearch found,
                                        std::optional<int>& bound);

/// The strokes in whole steps, (whole-steps).
/// @param tick called before samples are drawn
[[nodiscard]] PlanSearch in_steps(PlanProblem& problem, PlanSearch found,
                                  const std::function<void()>& tick);

/// The best state with unlimited strokes, where no cable goes slack.
/// @param task of which limits of strokes are not used
[[nodiscard]] StrokedState unconstrained(PlanProblem& problem, const StrokedState& start,
                                         const StrokeTask& task);

}  // namespace taut
