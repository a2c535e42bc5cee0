// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "adjustment/plan_description.hpp"
#include "adjustment/plan_problem.hpp"
#include "adjustment/plan_search.hpp"
#include "adjustment/target_deviations.hpp"

namespace taut {

double Plan::largest_stroke() const {
    double result = 0.0;
    for (const PlannedStroke& stroke : strokes) {
        result = std::max(result, std::abs(stroke.stroke));
    }
    return result;
}

Plan plan_strokes(const BuiltNet& built, const FormTarget& target, const Limits& limits,
                  const PlanOptions& options, const Progress& progress) {
    if (!built.failed_because.empty() && !options.accept_failed) {
        throw FailedIdentification(
            fmt::format("the identification failed its checks: {}", built.failed_because));
    }
    constexpr int stages = 5;
    const auto report = [&](int done) { progress("planning", done, stages); };
    const FormTarget relative =
        with_median_weight_one(target, built.net, !options.target_tensions.empty());
    PlanProblem problem(built, relative, limits, options, progress);
    report(0);
    PlanSearch found = search_of_estimate(problem);
    report(1);
    if (problem.draws() > 0) {
        found = with_margins(problem, aimed_at_mean(problem, std::move(found)));
    }
    report(2);
    Plan plan;
    plan.iterations = found.search.iterations;
    plan.has_converged = found.search.has_converged;
    if (options.tolerance) {
        found = turning_fewest(problem, std::move(found), plan.fewest_bound);
    }
    report(3);
    plan.normal_rmse_of_free_strokes = problem.deviation(found.search.found).normal_rmse;
    if (options.turn && options.turn->step() > 0.0) {
        found = in_steps(problem, std::move(found), [&] { report(3); });
    }
    report(4);
    describe_plan(plan, problem, found);
    report(stages);
    return plan;
}

}  // namespace taut
