// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/stroke_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adjustment/stroke_program.hpp"
#include "adjustment/target_deviations.hpp"

namespace taut {
namespace {

constexpr int most_searches = 60;
constexpr double first_radius = 5e-3;     ///< [m]
constexpr double smallest_radius = 1e-8;  ///< [m]
constexpr double smallest_gain = 1e-6;    ///< of the merit
/// Between the faces of a mesh the merit has kinks. There the search ends at steps below this [m]
/// that promise less than this part of the merit: no turnbuckle can be set so finely.
constexpr double step_along_kink = 1e-5;
constexpr double gain_along_kink = 1e-3;

}  // namespace

double merit_of(const StrokeTask& task, double cost, const Eigen::VectorXd& strokes,
                double violation) {
    return cost + turning_weight * strokes.squaredNorm() / static_cast<double>(strokes.size()) +
           task.violation_weight * violation;
}

double merit_of(const StrokeTask& task, const StrokedState& state) {
    return merit_of(task, state.cost, state.strokes, state.violation);
}

bool StrokedState::balanced() const {
    return std::ranges::all_of(nets,
                               [](const StrokedNet& net) { return net.equilibrium.balanced(); });
}

StrokedState state_at(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                      const Eigen::VectorXd& strokes, const StrokedState* near) {
    StrokedState state{.strokes = strokes, .nets = {}};
    for (size_t i = 0; i < responses.size(); ++i) {
        task.progress.throw_if_stopped();
        const Points& start = near != nullptr ? near->nets[i].equilibrium.form : responses[i].start;
        StrokeResponse& response = responses[i].response;
        state.nets.push_back(response.at(response.net().unstressed_lengths(), strokes, start));
        state.violation += responses[i].range.violation(state.nets.back().forces);
    }
    if (!state.balanced()) {
        state.cost = std::numeric_limits<double>::infinity();
        return state;
    }
    state.cost = cost_of(task, responses.front().response.net(), state.nets.front());
    return state;
}

StrokeSearch search_strokes(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                            const StrokedState& start) {
    StrokeSearch search{.found = start};
    if (!start.balanced()) {  // no tangent, and no merit that a step could lower
        return search;
    }
    double radius = first_radius;
    StrokeProgram program(responses, task, search.found);
    while (search.iterations < most_searches) {
        ++search.iterations;
        const std::optional<ProposedStrokes> proposed = program.solve(radius);
        if (!proposed) {
            break;
        }
        const double before = merit_of(task, search.found);
        const double promised = before - proposed->merit;
        const bool is_at_kink = task.target->surface() != nullptr && radius < step_along_kink &&
                                promised <= gain_along_kink * before;
        if (promised <= smallest_gain * before || is_at_kink) {
            search.has_converged = true;
            break;
        }
        StrokedState next = state_at(responses, task, proposed->strokes, &search.found);
        const double gained = before - merit_of(task, next);
        const double step = (next.strokes - search.found.strokes).cwiseAbs().maxCoeff();
        if (gained > 0.1 * promised) {
            if (gained > 0.75 * promised && step > 0.9 * radius) {
                radius *= 2.0;
            }
            search.found = std::move(next);
            program = StrokeProgram(responses, task, search.found);
        } else {
            radius = 0.25 * step;
            if (radius < smallest_radius) {
                // No step helps: converged if the promised gain is within rounding errors.
                search.has_converged = promised <= 1e-3 * before;
                break;
            }
        }
    }
    return search;
}

}  // namespace taut
