// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/stroke_search.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// What a plan is made for: the net under all loads, its limits and targets, and its state as
/// built. Searches name the limits that they are to keep: under().
class PlanProblem {
public:
    /// Keeps references.
    /// @param progress asked whether to stop
    /// @throws std::invalid_argument, RequestError as plan_strokes()
    PlanProblem(const BuiltNet& built, const FormTarget& target, const Limits& limits,
                const PlanOptions& options, const Progress& progress);
    PlanProblem(const PlanProblem&) = delete;
    PlanProblem& operator=(const PlanProblem&) = delete;

    [[nodiscard]] const BuiltNet& built() const { return m_built; }
    [[nodiscard]] const CableNet& net() const { return m_built.net; }
    [[nodiscard]] const FormTarget& target() const { return m_target; }
    [[nodiscard]] const Limits& limits() const { return m_limits; }
    [[nodiscard]] const PlanOptions& options() const { return m_options; }
    [[nodiscard]] const std::vector<int>& edges() const { return m_edges; }  ///< to turn (k)
    [[nodiscard]] Eigen::Index draws() const { return m_built.length_draws.cols(); }
    /// The limits as given: of the net's loads, then of each load case.
    [[nodiscard]] const std::vector<ForceRange>& given() const { return m_given; }
    /// With the limits of strokes and the target tensions as given.
    [[nodiscard]] const StrokeTask& task() const { return m_task; }
    [[nodiscard]] const StrokedState& as_built() const { return m_as_built; }

    /// The nets under all loads, with these limits: of the arguments of a search, until the next
    /// call.
    [[nodiscard]] std::vector<LimitedResponse>& under(const std::vector<ForceRange>& ranges);
    [[nodiscard]] const CableNet& net_under_loads(size_t i) const {
        return m_responses[i].response.net();
    }
    /// The samples at a state.
    [[nodiscard]] DrawnStrokes drawn(const StrokedState& state) const {
        return drawn(state, m_options.actuator_std);
    }
    [[nodiscard]] DrawnStrokes drawn(const StrokedState& state, double actuator_std) const;

    /// A force above this over a limit breaks it [N].
    [[nodiscard]] double negligible_excess() const;
    [[nodiscard]] bool is_violated(const StrokedState& state) const {
        return state.violation > negligible_excess();
    }
    [[nodiscard]] FormDeviation deviation(const StrokedState& state) const;

private:
    void add_response(const CableNet& net, const TensionLimits& tension);

    const BuiltNet& m_built;
    const FormTarget& m_target;
    const Limits& m_limits;
    const PlanOptions& m_options;
    std::vector<int> m_edges;
    std::vector<CableNet> m_case_nets;
    std::vector<LimitedResponse> m_responses;
    std::vector<ForceRange> m_given;
    StrokeTask m_task;
    StrokedState m_as_built;
    double m_force_unit = 1.0;
};

/// A state with its violation of these limits.
[[nodiscard]] StrokedState with_violation(StrokedState state,
                                          const std::vector<ForceRange>& ranges);

}  // namespace taut
