// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/plan_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "adjustment/drawn_steps.hpp"
#include "adjustment/fewest_strokes.hpp"
#include "adjustment/force_ranges.hpp"
#include "adjustment/target_deviations.hpp"
#include "adjustment/whole_steps.hpp"

namespace taut {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// The best form within the limits; where they cannot be kept, the least violation.
/// @param before steps of the search until here
StrokeSearch feasible_first(PlanProblem& problem, const StrokeTask& task,
                            const std::vector<ForceRange>& ranges, const StrokedState& start,
                            int before = 0) {
    std::vector<LimitedResponse>& responses = problem.under(ranges);
    StrokeSearch search = search_strokes(responses, task, with_violation(start, ranges));
    if (problem.is_violated(search.found)) {
        StrokeTask limits_first = task;
        limits_first.violation_weight *= 1e3;
        before += search.iterations;
        search = search_strokes(responses, limits_first, search.found);
    }
    search.iterations += before;
    return search;
}

}  // namespace

PlanSearch search_of_estimate(PlanProblem& problem) {
    return {.search = feasible_first(problem, problem.task(), problem.given(), problem.as_built()),
            .task = problem.task(),
            .effective = problem.given()};
}

PlanSearch aimed_at_mean(PlanProblem& problem, PlanSearch found) {
    constexpr int rounds = 4;
    constexpr double close_enough = 0.02;  // tolerances
    StrokeSearch& search = found.search;
    StrokeTask& task = found.task;
    for (int round = 0; round < rounds && !task.tensions.empty(); ++round) {
        const Eigen::MatrixXd drawn_forces = problem.drawn(search.found).forces.front();
        double most = 0.0;
        for (size_t i = 0; i < task.tensions.size(); ++i) {
            const TensionTarget& given = problem.task().tensions[i];
            double& aim = task.tensions[i].tension;
            const double before = aim;
            aim = given.tension - drawn_forces.row(given.edge).mean() +
                  search.found.nets.front().forces(given.edge);
            most = std::max(most, std::abs(aim - before) / given.tolerance);
        }
        search.found.cost = cost_of(task, problem.net(), search.found.nets.front());
        if (most < close_enough) {
            break;
        }
        search = feasible_first(problem, task, found.effective, search.found, search.iterations);
    }
    return found;
}

PlanSearch with_margins(PlanProblem& problem, PlanSearch found) {
    constexpr int rounds = 10;
    constexpr double close_enough =
        0.1;  // a margin is at most so much too wide [standard deviations]
    const double confidence = problem.options().confidence;
    double factor = 0.0;
    PlanSearch best = found;
    double best_shortfall = no_bound;
    for (int round = 0; round < rounds; ++round) {
        const StrokedState& state = found.search.found;
        const LimitMargins margins(problem.given(), state, problem.drawn(state));
        const double shortfall = margins.shortfall(confidence);
        const bool is_better = best_shortfall > 0.0
                                   ? shortfall < best_shortfall
                                   : shortfall <= 0.0 && state.cost < best.search.found.cost;
        if (is_better) {
            best = found;
            best_shortfall = shortfall;
        }
        if (round + 1 == rounds ||
            (shortfall <= 0.0 && (shortfall > -close_enough || factor == 0.0)) ||
            std::isinf(shortfall)) {
            break;
        }
        // A little more than the shortfall, since the next plan has other edges at their limits.
        // And the limits may be kept by more than the margin asked for.
        const double now = shortfall > 0.0 ? std::max(factor, margins.kept()) : factor;
        factor = std::max(0.0, now + shortfall + (shortfall > 0.0 ? 0.5 : 1.0) * 0.05);
        found.effective = margins.narrowed(factor);
        found.search =
            feasible_first(problem, found.task, found.effective, state, found.search.iterations);
    }
    best.search.found = with_violation(std::move(best.search.found), best.effective);
    return best;
}

PlanSearch turning_fewest(PlanProblem& problem, PlanSearch found, std::optional<int>& bound) {
    const CableNet& net = problem.net();
    StrokedState& state = found.search.found;
    FormTarget normal = problem.target();
    normal.set_weights(Eigen::VectorXd::Ones(net.node_count()),
                       Eigen::VectorXd::Zero(net.node_count()));
    StrokeTask task = found.task;
    task.target = &normal;
    task.form_tolerance = problem.options().tolerance.value();
    if (!is_within_tolerances(task, net, state.nets.front())) {
        return found;
    }
    state.cost = cost_of(task, net, state.nets.front());
    FewestStrokes fewest = fewest_strokes(problem.under(found.effective), task, state);
    bound = fewest.bound;
    state = std::move(fewest.found);
    for (Eigen::Index j = 0; j < state.strokes.size(); ++j) {
        if (std::abs(state.strokes(j)) < negligible_stroke) {
            found.task.shortest(j) = found.task.longest(j) = 0.0;
        }
    }
    state.cost = cost_of(found.task, net, state.nets.front());
    return found;
}

PlanSearch in_steps(PlanProblem& problem, PlanSearch found, const std::function<void()>& tick) {
    const double step = problem.options().turn.value().step();
    StrokedState& state = found.search.found;
    state = in_whole_steps(problem.under(found.effective), found.task, state, step);
    if (problem.draws() > 0) {
        const DrawnLimits limits{.confidence = problem.options().confidence,
                                 .draws = [&](const StrokedState& at) {
                                     tick();
                                     return problem.drawn(at);
                                 }};
        state =
            steps_holding_draws(problem.under(problem.given()), found.task, state, step, limits);
    }
    return found;
}

StrokedState unconstrained(PlanProblem& problem, const StrokedState& start,
                           const StrokeTask& task) {
    // No limit but that no cable goes slack.
    std::vector<ForceRange> ranges = problem.given();
    for (size_t i = 0; i < ranges.size(); ++i) {
        const CableNet& net = problem.net_under_loads(i);
        ranges[i].lower = ranges[i].lower.cwiseMin(least_taut(net));
        for (int e = 0; e < net.edge_count(); ++e) {
            if (net.is_strut(e)) {
                ranges[i].lower(e) = -no_bound;
            }
        }
        ranges[i].upper.setConstant(no_bound);
    }
    StrokeTask free = task;
    const Eigen::VectorXd lengths = problem.net().unstressed_lengths()(problem.edges());
    free.shortest = -0.5 * lengths;
    free.longest = 0.5 * lengths;
    StrokedState from = with_violation(start, ranges);
    from.cost = cost_of(free, problem.net(), from.nets.front());
    return search_strokes(problem.under(ranges), free, from).found;
}

}  // namespace taut
