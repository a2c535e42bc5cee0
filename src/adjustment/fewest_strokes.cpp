// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/fewest_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "adjustment/stroke_program.hpp"

namespace taut {
namespace {

constexpr int reweightings = 6;
constexpr double step_reach = 20e-3;     ///< of one linear step [m]
constexpr double negligible_use = 2e-5;  ///< shorter strokes count as none [m]

/// search_strokes() over the chosen edges alone.
StrokedState search_over(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                         const StrokedState& near, const std::vector<char>& chosen) {
    StrokeTask some = task;
    Eigen::VectorXd strokes = near.strokes;
    for (Eigen::Index j = 0; j < strokes.size(); ++j) {
        if (chosen[static_cast<size_t>(j)] == 0) {
            strokes(j) = some.shortest(j) = some.longest(j) = 0.0;
        }
    }
    return search_strokes(responses, some, state_at(responses, some, strokes, &near)).found;
}

}  // namespace

FewestStrokes fewest_strokes(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                             const StrokedState& all) {
    const Eigen::Index k = all.strokes.size();
    const auto keeps = [&](const StrokedState& state) {
        return state.balanced() && state.violation <= std::max(all.violation, 1e-9) &&
               is_within_tolerances(task, responses.front().response.net(), state.nets.front());
    };
    FewestStrokes result{.found = all};

    const Eigen::VectorXd span = task.longest.cwiseMax(-task.shortest).cwiseMax(1e-6);
    Eigen::VectorXd weights = span.cwiseInverse() * span.minCoeff();
    StrokedState state = all;
    for (int round = 0; round < reweightings; ++round) {
        const auto strokes =
            StrokeProgram(responses, task, state).least_turning(weights, step_reach);
        if (!strokes) {
            break;
        }
        if (round == 0) {
            // Every edge gives at most its span, so at least sum |x_j| / span_j edges are needed.
            result.bound =
                static_cast<int>(std::ceil(strokes->cwiseAbs().cwiseQuotient(span).sum() - 1e-6));
        }
        StrokedState next = state_at(responses, task, *strokes, &state);
        if (!next.balanced()) {
            break;
        }
        state = std::move(next);
        constexpr double softening = 1e-3;  // [m]
        weights = (state.strokes.cwiseAbs().array() + softening).inverse() * softening;
    }

    std::vector<char> chosen(static_cast<size_t>(k));
    for (Eigen::Index j = 0; j < k; ++j) {
        chosen[static_cast<size_t>(j)] = std::abs(state.strokes(j)) > negligible_use ? 1 : 0;
    }
    StrokedState best = search_over(responses, task, state, chosen);
    if (!keeps(best)) {
        best = all;
        chosen.assign(chosen.size(), 1);
    }
    // The shortest strokes are dropped first, eight at a time, at last one by one.
    for (size_t some = 8; some > 0;) {
        std::vector<int> order;
        for (Eigen::Index j = 0; j < k; ++j) {
            if (chosen[static_cast<size_t>(j)] != 0) {
                order.push_back(static_cast<int>(j));
            }
        }
        std::ranges::sort(order, {}, [&](int j) { return std::abs(best.strokes(j)); });
        bool has_dropped = false;
        for (size_t first = 0; first + some <= order.size() && first < 3 * some; first += some) {
            std::vector<char> fewer = chosen;
            for (size_t i = first; i < first + some; ++i) {
                fewer[static_cast<size_t>(order[i])] = 0;
            }
            StrokedState without = search_over(responses, task, best, fewer);
            if (keeps(without)) {
                best = std::move(without);
                chosen = std::move(fewer);
                has_dropped = true;
                break;
            }
        }
        if (!has_dropped) {
            some /= 2;
        }
    }
    result.found = std::move(best);
    return result;
}

}  // namespace taut
