// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/plan_description.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "adjustment/force_ranges.hpp"
#include "adjustment/limit_breaches.hpp"
#include "adjustment/survey_gain.hpp"
#include "adjustment/tension_targets.hpp"
#include "identification/drawn_summary.hpp"
#include "taut/identification/posterior_draws.hpp"

namespace taut {
namespace {

/// Parts along the target's normals, of the free nodes that have one: of each all samples.
/// @param forms 3 n_I x draws [m]
std::vector<Eigen::RowVectorXd> along_normals(const FormTarget& target, const CableNet& net,
                                              const Eigen::MatrixXd& forms) {
    std::vector<Eigen::RowVectorXd> result;
    for (int i = 0; i < net.free_node_count(); ++i) {
        const Eigen::Vector3d normal = target.normals().col(net.free_nodes()[i]);
        if (!normal.isZero(0.0)) {
            result.emplace_back(normal.transpose() * forms.middleRows(Eigen::Index{3} * i, 3));
        }
    }
    return result;
}

/// (survey-gain): targets on the net as it stands, for the planned form.
/// @param target at the planned form
std::vector<SuggestedTarget> suggested_targets(const PlanProblem& problem, const FormTarget& target,
                                               const DrawnStrokes& planned) {
    constexpr int most = 10;
    const CableNet& net = problem.net();
    const std::vector<Eigen::RowVectorXd> along = along_normals(target, net, planned.forms);
    Eigen::MatrixXd numbers(std::ssize(along), planned.forms.cols());
    for (Eigen::Index k = 0; k < numbers.rows(); ++k) {
        numbers.row(k) = along[static_cast<size_t>(k)];
    }
    std::vector<SuggestedTarget> result;
    for (const SurveyGain& gain :
         gains_of_targets(problem.drawn(problem.as_built(), 0.0).forms, numbers,
                          problem.options().survey_noise.value(), most)) {
        result.push_back({.node = net.free_nodes()[gain.place], .normal_std = gain.remaining_std});
    }
    return result;
}

/// Covariance of each node's place about the planned one (n) [m2].
/// @param moved coordinates from there (3 n_I x draws) [m]
std::vector<Eigen::Matrix3d> form_covariance(const BuiltNet& built, const Eigen::MatrixXd& moved) {
    const CableNet& net = built.net;
    const auto draws = static_cast<double>(moved.cols());
    std::vector<Eigen::Matrix3d> result(static_cast<size_t>(net.node_count()),
                                        Eigen::Matrix3d::Zero());
    for (const ModelPerturbation& one : built.perturbations) {
        for (const int node : net.supports()) {
            const Eigen::Vector3d moved_by = one.supports.col(node);
            result[static_cast<size_t>(node)] += moved_by * moved_by.transpose() / draws;
        }
    }
    for (int i = 0; i < net.free_node_count(); ++i) {
        const auto rows = moved.middleRows(Eigen::Index{3} * i, 3);
        result[static_cast<size_t>(net.free_nodes()[i])] = rows * rows.transpose() / draws;
    }
    return result;
}

/// Sets the 95 % intervals of the tensions.
void describe_drawn_tensions(Plan& plan, const CableNet& net, const Eigen::MatrixXd& forces) {
    plan.tension_lower.resize(net.edge_count());
    plan.tension_upper.resize(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const DrawnEstimate tension =
            tension_of(net, e,
                       forces.row(e)
                           .unaryExpr([&](double force) { return carried(net, e, force); })
                           .transpose());
        plan.tension_lower(e) = tension.lower;
        plan.tension_upper(e) = tension.upper;
    }
}

/// Sets how surely the planned form is known.
void describe_drawn_form(Plan& plan, const PlanProblem& problem, const DrawnStrokes& drawn) {
    const CableNet& net = problem.net();
    const Eigen::VectorXd planned = free_coordinates(net, plan.form);
    const Eigen::MatrixXd moved = drawn.forms.colwise() - planned;
    plan.form_covariance = form_covariance(problem.built(), moved);
    for (int node = 0; node < net.node_count(); ++node) {
        plan.form_std.col(node) =
            plan.form_covariance[static_cast<size_t>(node)].diagonal().cwiseSqrt();
    }
    const FormTarget target = problem.target().at(plan.form);
    const std::vector<Eigen::RowVectorXd> along = along_normals(target, net, moved);
    double variance = 0.0;
    for (const Eigen::RowVectorXd& of_node : along) {
        variance += of_node.squaredNorm() / static_cast<double>(problem.draws());
    }
    plan.normal_std = along.empty() ? 0.0 : std::sqrt(variance / static_cast<double>(along.size()));
    if (problem.options().survey_noise) {
        plan.suggested_targets = suggested_targets(problem, target, drawn);
    }
}

/// Sets how surely limits are kept.
/// @param draws of the state; null: none
void describe_limits(Plan& plan, const PlanProblem& problem, const StrokedState& state,
                     const DrawnStrokes* draws) {
    const double confidence = problem.options().confidence;
    // The estimate must keep the limits, too: samples of the lengths of slack cables may miss a
    // violation of it.
    plan.is_feasible = !problem.is_violated(with_violation(state, problem.given()));
    if (draws != nullptr) {
        const LimitMargins margins(problem.given(), state, *draws);
        plan.draws = static_cast<int>(problem.draws());
        plan.draws_needed = draws_needed(confidence, problem.draws());
        plan.limit_probability = margins.probability();
        plan.is_feasible = plan.is_feasible && margins.shortfall(confidence) <= 0.0;
    } else {
        plan.no_draws_because = problem.built().no_draws_because;
    }
    // Where the plan is not feasible, each that is broken in any sample.
    plan.breaches = limit_breaches(problem, state, draws, plan.is_feasible ? confidence : 1.0);
}

/// @param draws of the state; null: none
std::vector<ReachedTension> described_tensions(PlanProblem& problem, const StrokeTask& task,
                                               const StrokedState& state,
                                               const StrokedState& unlimited,
                                               const DrawnStrokes* draws) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.net().node_count());
    FormTarget any_form = problem.target();
    any_form.set_weights(none, none);
    StrokeTask tensions_alone = task;
    tensions_alone.target = &any_form;
    const StrokedState of_any_form = unconstrained(problem, unlimited, tensions_alone);
    return reached_tensions(problem.options().target_tensions, {.as_built = &problem.as_built(),
                                                                .planned = &state,
                                                                .unconstrained = &unlimited,
                                                                .of_any_form = &of_any_form,
                                                                .draws = draws});
}

/// Of the form and of the target tensions, as the target's objective.
bool is_within(const Plan& plan, FormObjective objective, double tolerance) {
    const bool is_rms = objective == FormObjective::rms;
    double square = 0.0;  // of the tensions, mean or largest
    for (const ReachedTension& reached : plan.target_tensions) {
        const double one = reached.deviation() * reached.deviation();
        square = is_rms ? square + one / static_cast<double>(plan.target_tensions.size())
                        : std::max(square, one);
    }
    return (is_rms ? plan.planned.normal_rmse : plan.planned.normal_max) <= tolerance &&
           square <= 1.0;
}

}  // namespace

void describe_plan(Plan& plan, PlanProblem& problem, const PlanSearch& found) {
    const CableNet& net = problem.net();
    const StrokedState& state = found.search.found;
    for (Eigen::Index j = 0; j < state.strokes.size(); ++j) {
        if (std::abs(state.strokes(j)) >= negligible_stroke) {
            plan.strokes.push_back(
                {.edge = problem.edges()[static_cast<size_t>(j)], .stroke = state.strokes(j)});
        }
    }
    plan.effective_limits = found.effective;
    plan.as_built = problem.deviation(problem.as_built());
    plan.planned = problem.deviation(state);
    plan.form = state.nets.front().equilibrium.form;
    plan.tensions = carried_tensions(net, state.nets.front().forces);
    plan.form_std = Eigen::MatrixXd::Zero(3, net.node_count());
    std::optional<DrawnStrokes> drawn;
    if (problem.draws() > 0) {
        drawn = problem.drawn(state);
        describe_drawn_tensions(plan, net, drawn->forces.front());
        describe_drawn_form(plan, problem, *drawn);
    }
    const DrawnStrokes* draws = drawn ? &*drawn : nullptr;
    describe_limits(plan, problem, state, draws);
    const StrokedState unlimited = unconstrained(problem, state, found.task);
    plan.unconstrained = problem.deviation(unlimited);
    if (!found.task.tensions.empty()) {
        plan.target_tensions = described_tensions(problem, found.task, state, unlimited, draws);
    }
    if (problem.options().tolerance) {
        plan.is_within_tolerance =
            is_within(plan, problem.target().objective(), *problem.options().tolerance);
    }
}

}  // namespace taut
