// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/request_error.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/drawn_steps.hpp"
#include "adjustment/fewest_strokes.hpp"
#include "adjustment/force_ranges.hpp"
#include "adjustment/stroke_program.hpp"
#include "adjustment/survey_gain.hpp"
#include "adjustment/target_deviations.hpp"
#include "adjustment/tension_targets.hpp"
#include "adjustment/whole_steps.hpp"
#include "taut/identification/posterior_draws.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {
namespace {

/// A violation by the mean tension costs so many times the deviations as built.
constexpr double violation_cost = 1e3;

/// Pitches of turnbuckles and jacks; a value outside is in another unit [m].
constexpr double finest_pitch = 1e-5;
constexpr double coarsest_pitch = 0.2;
constexpr double rounding = 1e-9;

void check_options(const BuiltNet& built, const PlanOptions& options,
                   const std::vector<int>& edges) {
    const CableNet& net = built.net;
    if (edges.empty()) {
        throw std::invalid_argument("no edge may be turned, expected at least one adjustable edge");
    }
    for (size_t k = 0; k < edges.size(); ++k) {
        if (edges[k] < 0 || edges[k] >= net.edge_count() || (k > 0 && edges[k] <= edges[k - 1])) {
            throw std::invalid_argument(
                fmt::format("the edges to turn contain edge {}, expected each of the {} edges at "
                            "most once, in ascending order",
                            edges[k], net.edge_count()));
        }
    }
    if (!(options.confidence > 0.0 && options.confidence < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "the confidence is {:g}, expected more than 0 and less than 1", options.confidence));
    }
    const auto draws = static_cast<double>(built.length_draws.cols());
    if (draws > 0.0 && draws * (1.0 - options.confidence) < 1.0 - rounding) {
        throw std::invalid_argument(
            fmt::format("the confidence is {:g}, but {} posterior samples show at most {:.4g}: "
                        "draw more samples, or lower the confidence",
                        options.confidence, draws, 1.0 - 1.0 / draws));
    }
    const double most_std = most_turned_part * net.unstressed_lengths()(edges).minCoeff();
    if (!(options.actuator_std >= 0.0 && options.actuator_std <= most_std)) {
        throw std::invalid_argument(
            fmt::format("the actuator std is {:g} m, expected 0 to {:.3g} m, a quarter of the "
                        "shortest edge to turn",
                        options.actuator_std, most_std));
    }
    if (options.tolerance && !(*options.tolerance > 0.0 && std::isfinite(*options.tolerance))) {
        throw std::invalid_argument(
            fmt::format("the tolerance is {:g} m, expected more than 0", *options.tolerance));
    }
    if (options.form_tolerance &&
        !(*options.form_tolerance > 0.0 && std::isfinite(*options.form_tolerance))) {
        throw RequestError("form_tolerance", fmt::format("is {}, expected more than 0",
                                                         format_length(*options.form_tolerance)));
    }
    if (options.survey_noise &&
        !(*options.survey_noise > 0.0 && std::isfinite(*options.survey_noise))) {
        throw std::invalid_argument(
            fmt::format("the standard deviation of suggested targets is {:g} m, expected above 0",
                        *options.survey_noise));
    }
    if (options.turn) {
        if (!(options.turn->pitch >= finest_pitch && options.turn->pitch <= coarsest_pitch)) {
            throw std::invalid_argument(fmt::format("a turn is {:g} m, expected {:g} to {:g} m",
                                                    options.turn->pitch, finest_pitch,
                                                    coarsest_pitch));
        }
        constexpr double smallest_part = 1e-3;
        if (options.turn->smallest != 0.0 &&
            !(options.turn->smallest >= smallest_part && options.turn->smallest <= 1.0)) {
            throw RequestError("step", fmt::format("is {:g} of a turn, expected {:g} to 1",
                                                   options.turn->smallest, smallest_part));
        }
    }
    if (built.length_draws.cols() > 0 &&
        (built.length_draws.rows() != net.edge_count() || !built.length_draws.allFinite() ||
         !(built.length_draws.minCoeff() > 0.0))) {
        throw std::invalid_argument(fmt::format(
            "the posterior samples of lengths are not {} positive numbers each, one per edge",
            net.edge_count()));
    }
}

/// Makes one plan: the nets under all loads, the limits, and the searches for strokes.
class Planning {
public:
    Planning(const BuiltNet& built, const FormTarget& target, const Limits& limits,
             const PlanOptions& options, const Progress& progress)
        : m_built(&built),
          m_target(&target),
          m_limits(&limits),
          m_options(&options),
          m_progress(&progress),
          m_edges(options.edges.empty() ? built.net.adjustable_edges() : options.edges) {
        check_options(built, options, m_edges);
        check_limits(built.net, m_edges, limits);
        check_tension_targets(built.net, options.target_tensions, limits.tension);
        m_case_nets.reserve(limits.load_cases.size());
        for (const LoadCase& load_case : limits.load_cases) {
            m_case_nets.push_back(with_loads(built.net, load_case.loads));
        }
        add_response(built.net, limits.tension, limits.reactions);
        for (size_t i = 0; i < m_case_nets.size(); ++i) {
            add_response(m_case_nets[i], limits.load_cases[i].tension, limits.reactions);
        }
        m_given = limits_now();
        m_task = {.target = m_target,
                  .shortest = limits.shortest_stroke,
                  .longest = limits.longest_stroke,
                  .tensions = options.target_tensions,
                  .form_tolerance = options.weighing_tolerance()};
        m_as_built = state_at(m_responses, m_task, Eigen::VectorXd::Zero(count()), nullptr);
        if (!m_as_built.balanced()) {
            throw std::invalid_argument("the built net finds no equilibrium");
        }
        m_force_unit = std::max(m_as_built.nets.front().equilibrium.mean_tension, 1e-9);
        m_task.violation_weight = violation_cost * std::max(m_as_built.cost, 1e-12) / m_force_unit;
    }

    Plan make() {
        report_progress(0);
        StrokeSearch search = feasible_first(m_as_built);
        report_progress(1);
        if (draws() > 0) {
            if (!m_task.tensions.empty()) {
                aim_at_mean(search);
            }
            search = with_margins(std::move(search));
        }
        report_progress(2);
        Plan plan;
        plan.iterations = search.iterations;
        plan.has_converged = search.has_converged;
        StrokedState state = std::move(search.found);
        if (m_options->tolerance) {
            state = fewest(state, plan);
        }
        report_progress(3);
        plan.normal_rmse_of_free_strokes = deviation(state).normal_rmse;
        if (m_options->turn && m_options->turn->step() > 0.0) {
            state = in_whole_steps(m_responses, m_task, state, m_options->turn->step());
            if (draws() > 0) {
                const std::vector<ForceRange> effective = limits_now();
                set_limits(m_given);
                const DrawnLimits limits{.confidence = m_options->confidence,
                                         .draws = [&](const StrokedState& at) {
                                             report_progress(3);
                                             return drawn(at);
                                         }};
                state = steps_holding_draws(m_responses, m_task, state, m_options->turn->step(),
                                            limits);
                set_limits(effective);
            }
        }
        report_progress(4);
        plan.effective_limits = limits_now();
        describe(plan, state);
        report_progress(stages);
        return plan;
    }

private:
    static constexpr int stages = 5;

    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(m_edges.size()); }
    [[nodiscard]] Eigen::Index draws() const { return m_built->length_draws.cols(); }
    void report_progress(int done) const { (*m_progress)("planning", done, stages); }

    void add_response(const CableNet& net, const TensionLimits& tension,
                      const std::vector<ReactionLimit>& reactions) {
        m_responses.push_back({.response = StrokeResponse(net, m_edges, supports_of(reactions)),
                               .range = range_of(net, tension, reactions),
                               .start = m_built->net.nodes()});
    }

    void set_limits(const std::vector<ForceRange>& ranges) {
        for (size_t i = 0; i < m_responses.size(); ++i) {
            m_responses[i].range = ranges[i];
        }
    }

    [[nodiscard]] bool is_violated(const StrokedState& state) const {
        return state.violation > negligible_violation * m_force_unit;
    }

    /// The best form within the limits; where they cannot be kept, the least violation.
    StrokeSearch feasible_first(const StrokedState& start) {
        StrokeSearch search = search_strokes(m_responses, m_task, start);
        if (is_violated(search.found)) {
            StrokeTask limits_first = m_task;
            limits_first.violation_weight *= 1e3;
            const int before = search.iterations;
            search = search_strokes(m_responses, limits_first, search.found);
            search.iterations += before;
        }
        return search;
    }

    /// Moves the target tensions by how far the mean of the samples is from the estimate, so that
    /// the mean comes to the targets as given. That difference depends little on the strokes, so
    /// both are found in turn.
    void aim_at_mean(StrokeSearch& search) {
        constexpr int rounds = 4;
        constexpr double close_enough = 0.02;  // tolerances
        for (int round = 0; round < rounds; ++round) {
            const Eigen::MatrixXd drawn_forces = drawn(search.found).forces.front();
            double most = 0.0;
            for (size_t i = 0; i < m_task.tensions.size(); ++i) {
                const TensionTarget& given = m_options->target_tensions[i];
                double& aim = m_task.tensions[i].tension;
                const double before = aim;
                aim = given.tension - drawn_forces.row(given.edge).mean() +
                      search.found.nets.front().forces(given.edge);
                most = std::max(most, std::abs(aim - before) / given.tolerance);
            }
            search.found.cost = cost_of(m_task, m_built->net, search.found.nets.front());
            if (most < close_enough) {
                return;
            }
            const int before = search.iterations;
            search = feasible_first(search.found);
            search.iterations += before;
        }
    }

    /// Narrows the limits until the given ones are kept with the required probability. The margin
    /// depends on the plan, so both are found in turn.
    StrokeSearch with_margins(StrokeSearch search) {
        constexpr int rounds = 10;
        constexpr double close_enough =
            0.1;  // a margin is at most so much too wide [standard deviations]
        double factor = 0.0;
        StrokeSearch best = search;
        std::vector<ForceRange> best_limits = m_given;
        double best_shortfall = std::numeric_limits<double>::infinity();
        for (int round = 0; round < rounds; ++round) {
            const LimitMargins margins(m_given, search.found, drawn(search.found));
            const double shortfall = margins.shortfall(m_options->confidence);
            const bool is_better = best_shortfall > 0.0
                                       ? shortfall < best_shortfall
                                       : shortfall <= 0.0 && search.found.cost < best.found.cost;
            if (is_better) {
                best = search;
                best_shortfall = shortfall;
                best_limits = limits_now();
            }
            if (round + 1 == rounds ||
                (shortfall <= 0.0 && (shortfall > -close_enough || factor == 0.0)) ||
                std::isinf(shortfall)) {
                break;
            }
            // A little more than the shortfall, since the next plan has other edges at their
            // limits. And the limits may be kept by more than the margin asked for.
            const double now = shortfall > 0.0 ? std::max(factor, margins.kept()) : factor;
            factor = std::max(0.0, now + shortfall + (shortfall > 0.0 ? 0.5 : 1.0) * 0.05);
            set_limits(margins.narrowed(factor));
            refresh_state(search.found);
            const int before = search.iterations;
            search = feasible_first(search.found);
            search.iterations += before;
        }
        set_limits(best_limits);
        refresh_state(best.found);
        return best;
    }

    [[nodiscard]] std::vector<ForceRange> limits_now() const {
        std::vector<ForceRange> result;
        result.reserve(m_responses.size());
        for (const LimitedResponse& limited : m_responses) {
            result.push_back(limited.range);
        }
        return result;
    }

    /// Computes the violation of a state anew, after limits have changed.
    void refresh_state(StrokedState& state) const {
        state.violation = 0.0;
        for (size_t i = 0; i < m_responses.size(); ++i) {
            state.violation += m_responses[i].range.violation(state.nets[i].forces);
        }
    }

    StrokedState fewest(const StrokedState& all, Plan& plan) {
        FormTarget normal = *m_target;
        const Eigen::Index nodes = m_built->net.node_count();
        normal.set_weights(Eigen::VectorXd::Ones(nodes), Eigen::VectorXd::Zero(nodes));
        StrokeTask task = m_task;
        task.target = &normal;
        task.form_tolerance = *m_options->tolerance;
        if (!is_within_tolerances(task, m_built->net, all.nets.front())) {
            return all;
        }
        StrokedState near = all;
        near.cost = cost_of(task, m_built->net, all.nets.front());
        FewestStrokes fewest = fewest_strokes(m_responses, task, near);
        plan.fewest_bound = fewest.bound;
        for (Eigen::Index j = 0; j < count(); ++j) {
            if (std::abs(fewest.found.strokes(j)) < negligible_stroke) {
                m_task.shortest(j) = m_task.longest(j) = 0.0;
            }
        }
        fewest.found.cost = cost_of(m_task, m_built->net, fewest.found.nets.front());
        return fewest.found;
    }

    [[nodiscard]] static const Points& form_of(const StrokedState& state) {
        return state.nets.front().equilibrium.form;
    }

    [[nodiscard]] FormDeviation deviation(const StrokedState& state) const {
        return deviation_from(*m_target, m_built->net, form_of(state));
    }

    [[nodiscard]] DrawnStrokes drawn(const StrokedState& state) const {
        return draw_strokes(*m_built, m_responses, state, m_options->actuator_std, m_options->seed);
    }

    /// The best state with unlimited strokes.
    /// @param task of which limits of strokes are not used
    StrokedState unconstrained(const StrokedState& state, const StrokeTask& task) {
        for (LimitedResponse& limited : m_responses) {
            // No limit but that no cable goes slack.
            const CableNet& net = limited.response.net();
            limited.range.lower = limited.range.lower.cwiseMin(least_taut(net));
            for (int e = 0; e < net.edge_count(); ++e) {
                if (net.is_strut(e)) {
                    limited.range.lower(e) = -std::numeric_limits<double>::infinity();
                }
            }
            limited.range.upper.setConstant(std::numeric_limits<double>::infinity());
        }
        StrokeTask free = task;
        const Eigen::VectorXd lengths = m_built->net.unstressed_lengths()(m_edges);
        free.shortest = -0.5 * lengths;
        free.longest = 0.5 * lengths;
        StrokedState start = state;
        refresh_state(start);
        start.cost = cost_of(free, m_built->net, start.nets.front());
        StrokeSearch search = search_strokes(m_responses, free, start);
        set_limits(m_given);
        return std::move(search.found);
    }

    /// @param draws of the state; null: none
    void describe_tensions(Plan& plan, const StrokedState& state, const StrokedState& unlimited,
                           const DrawnStrokes* draws) {
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(m_built->net.node_count());
        FormTarget any_form = *m_target;
        any_form.set_weights(none, none);
        StrokeTask task = m_task;
        task.target = &any_form;
        const StrokedState of_any_form = unconstrained(unlimited, task);
        plan.target_tensions =
            reached_tensions(m_options->target_tensions, {.as_built = &m_as_built,
                                                          .planned = &state,
                                                          .unconstrained = &unlimited,
                                                          .of_any_form = &of_any_form,
                                                          .draws = draws});
    }

    /// Of the form and of the target tensions, as the target's objective.
    [[nodiscard]] bool is_within_tolerance(const Plan& plan) const {
        const bool is_rms = m_target->objective() == FormObjective::rms;
        double square = 0.0;  // of the tensions, mean or largest
        for (const ReachedTension& reached : plan.target_tensions) {
            const double one = reached.deviation() * reached.deviation();
            square = is_rms ? square + one / static_cast<double>(plan.target_tensions.size())
                            : std::max(square, one);
        }
        return (is_rms ? plan.planned.normal_rmse : plan.planned.normal_max) <=
                   *m_options->tolerance &&
               square <= 1.0;
    }

    void describe(Plan& plan, const StrokedState& state) {
        const CableNet& net = m_built->net;
        for (Eigen::Index j = 0; j < count(); ++j) {
            if (std::abs(state.strokes(j)) >= negligible_stroke) {
                plan.strokes.push_back(
                    {.edge = m_edges[static_cast<size_t>(j)], .stroke = state.strokes(j)});
            }
        }
        plan.as_built = deviation(m_as_built);
        plan.planned = deviation(state);
        plan.form = form_of(state);
        plan.tensions = carried_tensions(net, state.nets.front().forces);
        plan.form_std = Eigen::MatrixXd::Zero(3, net.node_count());
        set_limits(m_given);
        std::optional<DrawnStrokes> drawn_strokes;
        if (draws() > 0) {
            drawn_strokes = drawn(state);
            describe_draws(plan, state, *drawn_strokes);
        } else {
            plan.no_draws_because = m_built->no_draws_because;
            StrokedState given = state;
            refresh_state(given);
            plan.is_feasible = !is_violated(given);
            list_breaches(plan, state, nullptr);
        }
        const StrokedState unlimited = unconstrained(state, m_task);
        plan.unconstrained = deviation(unlimited);
        if (!m_task.tensions.empty()) {
            describe_tensions(plan, state, unlimited, drawn_strokes ? &*drawn_strokes : nullptr);
        }
        if (m_options->tolerance) {
            plan.is_within_tolerance = is_within_tolerance(plan);
        }
    }

    void describe_draws(Plan& plan, const StrokedState& state, const DrawnStrokes& drawn_strokes) {
        const CableNet& net = m_built->net;
        const LimitMargins margins(m_given, state, drawn_strokes);
        plan.draws = static_cast<int>(draws());
        plan.draws_needed = draws_needed(m_options->confidence, draws());
        plan.limit_probability = margins.probability();
        // The estimate must keep the limits, too: samples of the lengths of slack cables may miss a
        // violation of it.
        StrokedState given = state;
        refresh_state(given);
        plan.is_feasible = margins.shortfall(m_options->confidence) <= 0.0 && !is_violated(given);
        plan.tension_lower.resize(net.edge_count());
        plan.tension_upper.resize(net.edge_count());
        for (int e = 0; e < net.edge_count(); ++e) {
            const DrawnEstimate tension =
                estimate_of(drawn_strokes.forces.front()
                                .row(e)
                                .unaryExpr([&](double force) { return carried(net, e, force); })
                                .transpose());
            plan.tension_lower(e) = tension.lower;
            plan.tension_upper(e) = tension.upper;
        }
        const FormTarget target = m_target->at(plan.form);
        double variance = 0.0;
        int with_normal = 0;
        const Eigen::VectorXd planned = free_coordinates(net, plan.form);
        const Eigen::MatrixXd moved = drawn_strokes.forms.colwise() - planned;
        plan.form_covariance.assign(static_cast<size_t>(net.node_count()), Eigen::Matrix3d::Zero());
        for (const ModelPerturbation& drawn_one : m_built->perturbations) {
            for (const int node : net.supports()) {
                const Eigen::Vector3d moved_by = drawn_one.supports.col(node);
                plan.form_covariance[static_cast<size_t>(node)] +=
                    moved_by * moved_by.transpose() / static_cast<double>(draws());
            }
        }
        for (int i = 0; i < net.free_node_count(); ++i) {
            const int node = net.free_nodes()[i];
            const auto rows = moved.middleRows(Eigen::Index{3} * i, 3);
            plan.form_covariance[static_cast<size_t>(node)] =
                rows * rows.transpose() / static_cast<double>(draws());
            const Eigen::Vector3d normal = target.normals().col(node);
            if (!normal.isZero(0.0)) {
                variance +=
                    (normal.transpose() * rows).squaredNorm() / static_cast<double>(draws());
                ++with_normal;
            }
        }
        plan.normal_std = with_normal > 0 ? std::sqrt(variance / with_normal) : 0.0;
        for (int node = 0; node < net.node_count(); ++node) {
            plan.form_std.col(node) =
                plan.form_covariance[static_cast<size_t>(node)].diagonal().cwiseSqrt();
        }
        if (m_options->survey_noise) {
            suggest_targets(plan, drawn_strokes);
        }
        list_breaches(plan, state, &drawn_strokes);
    }

    /// (survey-gain): targets on the net as it stands, for the planned form.
    void suggest_targets(Plan& plan, const DrawnStrokes& planned) const {
        constexpr int most = 10;
        const CableNet& net = m_built->net;
        const DrawnStrokes as_built =
            draw_strokes(*m_built, m_responses, m_as_built, 0.0, m_options->seed);
        const FormTarget target = m_target->at(plan.form);
        std::vector<Eigen::RowVectorXd> along;
        for (int i = 0; i < net.free_node_count(); ++i) {
            const Eigen::Vector3d normal = target.normals().col(net.free_nodes()[i]);
            if (!normal.isZero(0.0)) {
                along.emplace_back(normal.transpose() *
                                   planned.forms.middleRows(Eigen::Index{3} * i, 3));
            }
        }
        Eigen::MatrixXd numbers(std::ssize(along), planned.forms.cols());
        for (Eigen::Index k = 0; k < numbers.rows(); ++k) {
            numbers.row(k) = along[static_cast<size_t>(k)];
        }
        for (const SurveyGain& gain :
             gains_of_targets(as_built.forms, numbers, *m_options->survey_noise, most)) {
            plan.suggested_targets.push_back(
                {.node = net.free_nodes()[gain.place], .normal_std = gain.remaining_std});
        }
    }

    /// Lists each limit that is broken in the estimate, or kept with less than the required
    /// probability; where the plan is not feasible, each that is broken in any sample. Those that
    /// the estimate breaks come first.
    void list_breaches(Plan& plan, const StrokedState& state, const DrawnStrokes* drawn_strokes) {
        const std::vector<int> supports = supports_of(m_limits->reactions);
        std::vector<LimitBreach> of_draws;
        for (size_t i = 0; i < m_given.size(); ++i) {
            const Eigen::VectorXd& forces = state.nets[i].forces;
            for (Eigen::Index row = 0; row < forces.size(); ++row) {
                for (const bool is_lower : {true, false}) {
                    const double limit = is_lower ? m_given[i].lower(row) : m_given[i].upper(row);
                    if (std::isinf(limit)) {
                        continue;
                    }
                    const double sign = is_lower ? -1.0 : 1.0;
                    const bool is_kept =
                        sign * (forces(row) - limit) <= negligible_violation * m_force_unit;
                    double probability = is_kept ? 1.0 : 0.0;
                    if (drawn_strokes != nullptr) {
                        const auto drawn_row = drawn_strokes->forces[i].row(row).array();
                        probability = (sign * (drawn_row - limit) <= 0.0).cast<double>().mean();
                    }
                    if (is_kept &&
                        probability >= (plan.is_feasible ? m_options->confidence : 1.0)) {
                        continue;
                    }
                    const bool is_edge = row < m_built->net.edge_count();
                    (is_kept ? of_draws : plan.breaches)
                        .push_back({.kind = is_edge ? LimitBreach::Kind::tension
                                                    : LimitBreach::Kind::reaction,
                                    .index = is_edge ? static_cast<int>(row)
                                                     : supports[static_cast<size_t>(
                                                           row - m_built->net.edge_count())],
                                    .load_case = i == 0 ? "" : m_limits->load_cases[i - 1].name,
                                    .value = carried(m_built->net, row, forces(row)),
                                    .limit = given_limit(m_responses[i].response.net(), limit),
                                    .probability = probability});
                }
            }
        }
        const auto is_worse = [](const LimitBreach& a, const LimitBreach& b) {
            return std::tuple(a.probability, -std::abs(a.value - a.limit)) <
                   std::tuple(b.probability, -std::abs(b.value - b.limit));
        };
        std::ranges::stable_sort(plan.breaches, is_worse);
        std::ranges::stable_sort(of_draws, is_worse);
        std::ranges::move(of_draws, std::back_inserter(plan.breaches));
    }

    const BuiltNet* m_built;
    const FormTarget* m_target;
    const Limits* m_limits;
    const PlanOptions* m_options;
    const Progress* m_progress;
    std::vector<int> m_edges;
    std::vector<CableNet> m_case_nets;
    std::vector<LimitedResponse> m_responses;  ///< with the limits in force now
    std::vector<ForceRange> m_given;
    StrokeTask m_task;
    StrokedState m_as_built;
    double m_force_unit = 1.0;
};

}  // namespace

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
    const FormTarget relative =
        with_median_weight_one(target, built.net, !options.target_tensions.empty());
    return Planning(built, relative, limits, options, progress).make();
}

}  // namespace taut
