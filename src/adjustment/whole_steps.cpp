// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/whole_steps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "adjustment/stroke_program.hpp"

namespace taut {
namespace {

constexpr double step_rounding = 1e-9;  ///< of a step

double nearest_multiple(double stroke, double step, double shortest, double longest) {
    const double lowest = std::ceil(shortest / step - step_rounding);
    const double highest = std::floor(longest / step + step_rounding);
    return step * std::clamp(std::round(stroke / step), lowest, highest);
}

/// Fixes the strokes nearest to a whole step and searches the others anew, until all are fixed.
StrokedState fixed_by_quarters(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                               const StrokedState& free, double step) {
    StrokeTask left = task;
    StrokedState state = free;
    std::vector<int> open(static_cast<size_t>(free.strokes.size()));
    std::iota(open.begin(), open.end(), 0);
    Eigen::VectorXd multiples(free.strokes.size());
    while (!open.empty()) {
        for (const int j : open) {
            multiples(j) =
                nearest_multiple(state.strokes(j), step, task.shortest(j), task.longest(j));
        }
        Eigen::VectorXd strokes = state.strokes;
        for (const int j : next_to_fix(open, state.strokes, multiples)) {
            strokes(j) = left.shortest(j) = left.longest(j) = multiples(j);
            std::erase(open, j);
        }
        state = state_at(responses, task, strokes, &state);
        if (!open.empty()) {
            state = search_strokes(responses, left, state).found;
        }
    }
    return state;
}

/// Single steps, as long as one lowers the merit.
StrokedState improved_by_steps(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                               StrokedState state, double step) {
    constexpr int most_moves = 200;
    for (int moves = 0; moves < most_moves; ++moves) {
        const std::vector<ProposedStrokes> better =
            StrokeProgram(responses, task, state).single_steps(step);
        // The best to first order is tried first; after a few failures no step helps.
        constexpr size_t tries = 3;
        bool has_moved = false;
        for (size_t i = 0; i < std::min(tries, better.size()) && !has_moved; ++i) {
            StrokedState next = state_at(responses, task, better[i].strokes, &state);
            if (merit_of(task, next) < merit_of(task, state)) {
                state = std::move(next);
                has_moved = true;
            }
        }
        if (!has_moved) {
            break;
        }
    }
    return state;
}

}  // namespace

std::vector<int> next_to_fix(std::vector<int> open, const Eigen::VectorXd& strokes,
                             const Eigen::VectorXd& multiples) {
    std::ranges::sort(open, {}, [&](int j) { return std::abs(strokes(j) - multiples(j)); });
    open.resize(std::min(open.size(), std::max<size_t>(8, open.size() / 4)));
    return open;
}

StrokedState in_whole_steps(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                            const StrokedState& free, double step) {
    StrokedState by_rounding =
        improved_by_steps(responses, task, fixed_by_quarters(responses, task, free, step), step);
    // Steps may be so coarse that rounding all strokes is worse than turning nothing.
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(free.strokes.size());
    StrokedState from_none = state_at(responses, task, none, &free);
    return merit_of(task, from_none) < merit_of(task, by_rounding)
               ? improved_by_steps(responses, task, std::move(from_none), step)
               : by_rounding;
}

}  // namespace taut
