// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/plan_problem.hpp"

#include <algorithm>
#include <stdexcept>

#include "adjustment/force_ranges.hpp"
#include "adjustment/plan_options.hpp"
#include "adjustment/target_deviations.hpp"
#include "adjustment/tension_targets.hpp"

namespace taut {

PlanProblem::PlanProblem(const BuiltNet& built, const FormTarget& target, const Limits& limits,
                         const PlanOptions& options, const Progress& progress)
    : m_built(built),
      m_target(target),
      m_limits(limits),
      m_options(options),
      m_edges(options.edges.empty() ? built.net.adjustable_edges() : options.edges) {
    check_plan_options(built, options, m_edges);
    check_limits(built.net, m_edges, limits);
    check_tension_targets(built.net, options.target_tensions, limits.tension);
    m_case_nets.reserve(limits.load_cases.size());  // responses point to them
    add_response(built.net, limits.tension);
    for (const LoadCase& load_case : limits.load_cases) {
        m_case_nets.push_back(with_loads(built.net, load_case.loads));
        add_response(m_case_nets.back(), load_case.tension);
    }
    m_task = {.target = &m_target,
              .shortest = limits.shortest_stroke,
              .longest = limits.longest_stroke,
              .tensions = options.target_tensions,
              .form_tolerance = options.weighing_tolerance(),
              .progress = {.report = {}, .stop_requested = progress.stop_requested}};
    m_as_built = state_at(m_responses, m_task, Eigen::VectorXd::Zero(std::ssize(m_edges)), nullptr);
    if (!m_as_built.balanced()) {
        throw std::invalid_argument("the built net finds no equilibrium");
    }
    // A violation by the mean tension costs so many times the deviations as built.
    constexpr double violation_cost = 1e3;
    m_force_unit = std::max(m_as_built.nets.front().equilibrium.mean_tension, 1e-9);
    m_task.violation_weight = violation_cost * std::max(m_as_built.cost, 1e-12) / m_force_unit;
}

void PlanProblem::add_response(const CableNet& net, const TensionLimits& tension) {
    m_given.push_back(range_of(net, tension, m_limits.reactions));
    m_responses.push_back(
        {.response = StrokeResponse(net, m_edges, supports_of(m_limits.reactions)),
         .range = m_given.back(),
         .start = m_built.net.nodes()});
}

std::vector<LimitedResponse>& PlanProblem::under(const std::vector<ForceRange>& ranges) {
    for (size_t i = 0; i < m_responses.size(); ++i) {
        m_responses[i].range = ranges[i];
    }
    return m_responses;
}

DrawnStrokes PlanProblem::drawn(const StrokedState& state, double actuator_std) const {
    return draw_strokes(m_built, m_responses, state, actuator_std, m_options.seed, m_task.progress);
}

double PlanProblem::negligible_excess() const {
    return negligible_violation * m_force_unit;
}

FormDeviation PlanProblem::deviation(const StrokedState& state) const {
    return deviation_from(m_target, net(), state.nets.front().equilibrium.form);
}

StrokedState with_violation(StrokedState state, const std::vector<ForceRange>& ranges) {
    state.violation = 0.0;
    for (size_t i = 0; i < ranges.size(); ++i) {
        state.violation += ranges[i].violation(state.nets[i].forces);
    }
    return state;
}

}  // namespace taut
