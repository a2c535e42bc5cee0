// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/suggested_edges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "adjustment/check_plan.hpp"
#include "adjustment/force_ranges.hpp"
#include "adjustment/stroke_search.hpp"
#include "adjustment/target_deviations.hpp"
#include "adjustment/tension_targets.hpp"
#include "net/sliding_nodes.hpp"
#include "numerics/small_dense.hpp"
#include "statics/arguments.hpp"

namespace taut {
namespace {

constexpr size_t exact_tries = 5;
constexpr double smallest_suggested_gain = 1e-3;  ///< of the cost
constexpr Eigen::Index columns_at_once = 256;

/// Edges that may be turned, the added ones last, and the best strokes found for them.
struct TurnedSet {
    std::vector<int> edges;
    Eigen::VectorXd shortest;
    Eigen::VectorXd longest;
    StrokedState state;
};

class SuggestionSearch {
public:
    SuggestionSearch(const BuiltNet& built, const FormTarget& target, const Limits& limits,
                     const PlanOptions& options, const Plan& plan, const Progress& progress)
        : m_net(&built.net),
          m_target(with_median_weight_one(target, built.net, !options.target_tensions.empty())),
          m_limits(&limits),
          m_options(&options),
          m_progress{.report = {}, .stop_requested = progress.stop_requested},
          m_plan(&plan) {
        for (const LoadCase& load_case : limits.load_cases) {
            m_case_nets.push_back(with_loads(built.net, load_case.loads));
        }
    }

    /// The edges of the plan, with its strokes no longer in whole steps.
    [[nodiscard]] TurnedSet planned(const std::vector<int>& edges) {
        TurnedSet set{.edges = edges,
                      .shortest = m_limits->shortest_stroke,
                      .longest = m_limits->longest_stroke};
        Eigen::VectorXd strokes = Eigen::VectorXd::Zero(std::ssize(edges));
        for (const PlannedStroke& stroke : m_plan->strokes) {
            strokes(std::ranges::find(edges, stroke.edge) - edges.begin()) = stroke.stroke;
        }
        improve(set, strokes);
        m_longest = std::max(set.longest.maxCoeff(), -set.shortest.minCoeff());
        return set;
    }

    /// A set with one more edge.
    [[nodiscard]] TurnedSet with(const TurnedSet& set, int edge) {
        const Eigen::Index k = std::ssize(set.edges);
        TurnedSet wider{.edges = set.edges, .shortest = set.shortest, .longest = set.longest};
        wider.edges.push_back(edge);
        wider.shortest.conservativeResize(k + 1);
        wider.longest.conservativeResize(k + 1);
        wider.shortest(k) = -reach_of(edge);
        wider.longest(k) = reach_of(edge);
        Eigen::VectorXd strokes = Eigen::VectorXd::Zero(k + 1);
        strokes.head(k) = set.state.strokes;
        improve(wider, strokes);
        return wider;
    }

    /// Edges that are not in the set, by how much they lower the cost to first order
    /// (suggested-edges): by (a . z)^2 / |a|^2 with the residual z and the edge's column a, from
    /// which the columns of the set are projected out; less where the stroke is limited.
    [[nodiscard]] std::vector<int> ranked(const TurnedSet& set) const {
        const StrokedNet& stroked = set.state.nets.front();
        const StrokeTask task = task_of(set);
        const Eigen::VectorXd residual = deviations_from_targets(task, *m_net, stroked).values;
        const auto weighted_columns = [&](std::span<const int> edges) {
            const StrokeResponse response(*m_net, {edges.begin(), edges.end()}, {});
            return deviations_from_targets(task, *m_net, stroked, response.rates(stroked)).rates;
        };
        // Only strokes that are not at their limits can adapt to the new one.
        std::vector<int> adapting;
        for (Eigen::Index k = 0; k < std::ssize(set.edges); ++k) {
            constexpr double at_its_end = 1e-6;  // [m]
            const double stroke = set.state.strokes(k);
            if (stroke > set.shortest(k) + at_its_end && stroke < set.longest(k) - at_its_end) {
                adapting.push_back(set.edges[static_cast<size_t>(k)]);
            }
        }
        const Eigen::MatrixXd theirs =
            adapting.empty() ? Eigen::MatrixXd() : weighted_columns(adapting);
        const auto without_theirs = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
            if (adapting.empty()) {
                return columns;
            }
            return columns - theirs * minimum_norm_solution(theirs, columns);
        };
        std::vector<int> others;
        std::vector<int> turned = set.edges;  // with all that slides on when one of them is turned
        for (const std::vector<int>& stretch : sliding_stretches(*m_net)) {
            if (std::ranges::find_first_of(stretch, set.edges) != stretch.end()) {
                turned.insert(turned.end(), stretch.begin(), stretch.end());
            }
        }
        for (int edge = 0; edge < m_net->edge_count(); ++edge) {
            if (std::ranges::find(turned, edge) == turned.end()) {
                others.push_back(edge);
            }
        }
        std::vector<std::pair<double, int>> gains;
        for (size_t first = 0; first < others.size(); first += columns_at_once) {
            const std::span<const int> some(
                others.begin() + static_cast<std::ptrdiff_t>(first),
                std::min(others.size() - first, static_cast<size_t>(columns_at_once)));
            const Eigen::MatrixXd columns = without_theirs(weighted_columns(some));
            for (size_t i = 0; i < some.size(); ++i) {
                const auto column = columns.col(static_cast<Eigen::Index>(i));
                const double square = column.squaredNorm();
                const double slope = column.dot(residual);
                const double reach = reach_of(some[i]);
                const double stroke =
                    square > 0.0 ? std::clamp(-slope / square, -reach, reach) : 0.0;
                gains.emplace_back(-stroke * (2.0 * slope + stroke * square), some[i]);
            }
        }
        std::ranges::sort(gains, std::ranges::greater());
        std::vector<int> result;
        for (const auto& [gain, edge] : gains) {
            if (gain > 0.0) {
                result.push_back(edge);
            }
        }
        return result;
    }

    [[nodiscard]] double merit(const TurnedSet& set) const {
        return merit_of(task_of(set), set.state);
    }

private:
    [[nodiscard]] double reach_of(int edge) const {
        return std::min(m_longest, 0.5 * m_net->unstressed_lengths()(edge));
    }

    [[nodiscard]] StrokeTask task_of(const TurnedSet& set) const {
        return {.target = &m_target,
                .shortest = set.shortest,
                .longest = set.longest,
                .violation_weight = m_violation_weight,
                .tensions = m_options->target_tensions,
                .form_tolerance = m_options->weighing_tolerance(),
                .progress = m_progress};
    }

    /// Finds the best strokes of a set, from a start.
    void improve(TurnedSet& set, const Eigen::VectorXd& strokes) {
        std::vector<LimitedResponse> responses;
        for (size_t i = 0; i <= m_case_nets.size(); ++i) {
            responses.push_back(
                {.response = StrokeResponse(i == 0 ? *m_net : m_case_nets[i - 1], set.edges,
                                            supports_of(m_limits->reactions)),
                 .range = m_plan->effective_limits[i],
                 .start = m_plan->form});
        }
        StrokeTask task = task_of(set);
        const StrokedState start = state_at(responses, task, strokes, nullptr);
        if (m_violation_weight == 0.0) {
            // As plan_strokes(): limits come first.
            const StrokedState as_built =
                state_at(responses, task, Eigen::VectorXd::Zero(strokes.size()), nullptr);
            m_violation_weight = 1e3 * std::max(as_built.cost, 1e-12) /
                                 std::max(as_built.nets.front().equilibrium.mean_tension, 1e-9);
            task.violation_weight = m_violation_weight;
        }
        set.state = search_strokes(responses, task, start).found;
    }

    const CableNet* m_net;
    FormTarget m_target;
    const Limits* m_limits;
    const PlanOptions* m_options;
    Progress m_progress;  ///< without a report
    const Plan* m_plan;
    std::vector<CableNet> m_case_nets;
    double m_longest = 0.0;
    double m_violation_weight = 0.0;
};

}  // namespace

std::vector<SuggestedEdge> suggested_edges(const BuiltNet& built, const FormTarget& target,
                                           const Limits& limits, const PlanOptions& options,
                                           const Plan& plan, int count, const Progress& progress) {
    if (count < 1) {
        throw std::invalid_argument(fmt::format("{} suggested edges, expected at least 1", count));
    }
    const std::vector<int>& edges =
        options.edges.empty() ? built.net.adjustable_edges() : options.edges;
    check_limits(built.net, edges, limits);
    check_tension_targets(built.net, options.target_tensions, limits.tension);
    check_plan(built.net, limits, plan);
    check_form("plan", built.net.node_count(), plan.form);
    for (const PlannedStroke& stroke : plan.strokes) {
        if (std::ranges::find(edges, stroke.edge) == edges.end()) {
            throw std::invalid_argument(
                fmt::format("the plan turns edge '{}', which is not one of its adjustable edges",
                            built.net.edge_id(stroke.edge)));
        }
    }
    SuggestionSearch search(built, target, limits, options, plan, progress);
    TurnedSet set = search.planned(edges);
    std::vector<SuggestedEdge> result;
    for (int i = 0; i < count; ++i) {
        progress("suggested edges", i, count);
        std::optional<TurnedSet> best;
        const std::vector<int> ranked = search.ranked(set);
        for (size_t k = 0; k < std::min(exact_tries, ranked.size()); ++k) {
            TurnedSet wider = search.with(set, ranked[k]);
            if (!best || search.merit(wider) < search.merit(*best)) {
                best = std::move(wider);
            }
        }
        if (!best || search.merit(*best) > (1.0 - smallest_suggested_gain) * search.merit(set)) {
            break;
        }
        set = std::move(*best);
        const StrokedNet& reached = set.state.nets.front();
        result.push_back(
            {.edge = set.edges.back(),
             .stroke = set.state.strokes(set.state.strokes.size() - 1),
             .normal_rmse_after =
                 deviation_from(target, built.net, reached.equilibrium.form).normal_rmse,
             .tension_rmse_after = tension_rmse(options.target_tensions, reached.forces)});
    }
    progress("suggested edges", count, count);
    return result;
}

}  // namespace taut
