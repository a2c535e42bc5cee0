// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/other_explanations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "estimation/length_tests.hpp"

namespace taut {
namespace {
using BoundaryTest = Hypotheses::BoundaryTest;

/// Slack edges that the form leaves more length than their priors have, the most first.
std::set<int> improbably_slack(const FitProblem& problem, const Explanation& found) {
    constexpr size_t most = 8;
    constexpr double improbable = 2.0;  // standard deviations of the prior
    const CableNet& net = problem.net;
    const std::vector<int>& marked = problem.knowledge.forces.slack;
    const Iterate& at = found.at.iterate;
    std::vector<std::pair<double, int>> edges;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (!found.at.slack[e] || std::ranges::find(marked, e) != marked.end()) {
            continue;
        }
        const auto [s, t] = net.edges()[e];
        const double unused = found.linearisation->model().unstressed_length(e, at) -
                              (at.form.col(s) - at.form.col(t)).norm();
        const auto interior = std::ranges::lower_bound(net.interior_edges(), e);
        const bool is_interior = interior != net.interior_edges().end() && *interior == e;
        const auto place = interior - net.interior_edges().begin();
        const double std_dev = is_interior ? problem.knowledge.priors[place].std_dev() : 0.0;
        if (unused > improbable * std_dev) {
            edges.emplace_back(unused, e);
        }
    }
    std::ranges::sort(edges, std::greater());
    edges.resize(std::min(most, edges.size()));
    std::set<int> result;
    std::ranges::transform(edges, std::inserter(result, result.end()),
                           &std::pair<double, int>::second);
    return result;
}

/// (slip): the nodes of rejected targets and released edges, those of the largest statistics first.
std::vector<int> suspect_nodes(const Hypotheses& hypotheses) {
    constexpr size_t most = 8;
    std::vector<std::pair<double, int>> nodes;
    for (const Suspect kind : {Suspect::target, Suspect::length, Suspect::pair}) {
        for (const Hypothesis& found : hypotheses.found(kind)) {
            for (const int node : found.nodes) {
                if (node >= 0 && (!found.is_pair() || node == found.nodes[0])) {
                    nodes.emplace_back(found.largest_statistic(), node);
                }
            }
        }
    }
    std::ranges::stable_sort(nodes, std::greater{}, [](const auto& one) { return one.first; });
    std::vector<int> result;
    for (const auto& [statistic, node] : nodes) {
        if (std::ranges::find(result, node) == result.end() && result.size() < most) {
            result.push_back(node);
        }
    }
    return result;
}

/// Edges from the nodes of suspects to supports.
std::set<int> to_supports_nearby(const FitProblem& problem, const Hypotheses& hypotheses) {
    std::set<int> result;
    for (const int node : suspect_nodes(hypotheses)) {
        for (const int edge : problem.net.edges_at(node)) {
            const auto [s, t] = problem.net.edges()[edge];
            const std::vector<int>& marked = problem.knowledge.forces.slack;
            if (std::ranges::find(marked, edge) == marked.end() &&
                problem.net.is_support(s == node ? t : s)) {
                result.insert(edge);
            }
        }
    }
    return result;
}

/// With an edge released and taut, beside what is released already; the cost is infinite where it
/// cannot be.
Explanation with_taut_edge(const FitProblem& problem, Explanation other, int edge,
                           const FitMode& mode) {
    if (!other.hypotheses.release_edge(edge)) {
        other.cost = std::numeric_limits<double>::infinity();
        return other;
    }
    if (other.is_sound() && !other.at.slack[edge]) {
        return explain(problem, std::move(other.hypotheses), std::move(other.at), mode);
    }
    Explanation from_nominal = explain_from_nominal(problem, other.hypotheses, mode);
    const bool is_taut = from_nominal.is_sound() && !from_nominal.at.slack[edge];
    if (is_taut || !other.is_sound()) {
        return from_nominal;
    }
    other.at.slack[edge] = false;
    return explain(problem, std::move(other.hypotheses), std::move(other.at), mode);
}

/// Pairs of one run at a node that (slip) tries: those with no edge released in another pair.
/// @return places among the pairs
std::vector<int> pairs_at(int node, const Hypotheses& hypotheses) {
    std::vector<bool> in_pairs(hypotheses.of(Suspect::length).size(), false);
    for (const Hypothesis& pair : hypotheses.of(Suspect::pair)) {
        if (pair.is_released()) {
            in_pairs[pair.index] = true;
            in_pairs[pair.other] = true;
        }
    }
    std::vector<int> result;
    const std::span<const Hypothesis> pairs = hypotheses.of(Suspect::pair);
    for (int k = 0; k < static_cast<int>(pairs.size()); ++k) {
        const Hypothesis& pair = pairs[k];
        const bool is_free = pair.is_released() || (!in_pairs[pair.index] && !in_pairs[pair.other]);
        if (pair.nodes[0] == node && pair.is_of_one_run && is_free) {
            result.push_back(k);
        }
    }
    return result;
}

/// A fit with a pair released and the target at its node in use, or the other way round.
/// @param pair place among the pairs
Explanation with_pair(const FitProblem& problem, Explanation other, int pair, bool is_target) {
    Hypothesis& released = other.hypotheses.of(Suspect::pair)[pair];
    other.hypotheses.set_pair(released, !is_target);
    if (Hypothesis* target = other.hypotheses.find(Suspect::target, released.nodes[0])) {
        target->state = is_target ? Hypothesis::State::released : Hypothesis::State::in_use;
    }
    if (!is_target) {  // a shorter one that was taken for slack may be taut
        other.at.slack[problem.net.interior_edges()[released.index]] = false;
        other.at.slack[problem.net.interior_edges()[released.other]] = false;
    }
    other = fit(problem, std::move(other.hypotheses), std::move(other.at));
    if (other.is_sound()) {
        test_hypotheses(problem, other);
    }
    return other;
}

/// (slip): a slipped clamp instead of what was found at its node, where that costs less.
/// @param pair place among the pairs
std::optional<Explanation> instead_of(const FitProblem& problem, const Explanation& best,
                                      int pair) {
    // A target has two degrees of freedom more than a clamp: chi-squared exceeds this in 3 of
    // 1,000.
    constexpr double inseparable = 11.6;
    // A clamp has one degree of freedom more than a single edge: 1 of 100.
    constexpr double more_than_one_edge = 6.6;
    const Hypothesis before = best.hypotheses.of(Suspect::pair)[pair];
    const auto lengths = best.hypotheses.of(Suspect::length);
    const bool is_in_place_of_edge =
        lengths[before.index].is_released() || lengths[before.other].is_released();
    Explanation clamp = before.is_released() ? best : with_pair(problem, best, pair, false);
    Hypothesis& slipped = clamp.hypotheses.of(Suspect::pair)[pair];
    if (!(clamp.cost < best.cost + (is_in_place_of_edge ? -more_than_one_edge : inseparable)) ||
        !is_slip(slipped, problem.knowledge.priors)) {
        return std::nullopt;
    }
    Hypothesis* at_node = clamp.hypotheses.find(Suspect::target, before.nodes[0]);
    double cost_of_target = best.cost;
    if (at_node != nullptr) {
        Explanation target = best;
        if (!target.hypotheses.find(Suspect::target, at_node->index)->is_released()) {
            target = with_pair(problem, std::move(target), pair, true);
        }
        cost_of_target = target.cost;
        if (std::abs(clamp.cost - cost_of_target) < inseparable) {
            slipped.state = Hypothesis::State::released_for_good;
            at_node->state = Hypothesis::State::released_for_good;
            at_node->statistic = target.hypotheses.find(Suspect::target, at_node->index)->statistic;
            return clamp;  // to be fitted again
        }
    }
    if (!before.is_released() && clamp.cost < std::min(best.cost, cost_of_target)) {
        return clamp;
    }
    return std::nullopt;
}

}  // namespace

Explanation with_boundary(const FitProblem& problem, Explanation found) {
    const FitState start = found.at;
    Hypotheses hypotheses = found.hypotheses;
    for (const BoundaryTest test : {BoundaryTest::at_once, BoundaryTest::one_by_one}) {
        hypotheses.readmit_all();
        Explanation other = explain(problem, std::move(hypotheses), start, {.boundary = test});
        hypotheses = other.hypotheses;
        if (other.cost < found.cost) {
            found = std::move(other);
        }
    }
    return found;
}

Explanation with_taut_edges(const FitProblem& problem, Explanation found) {
    constexpr int most = 3;
    const bool has_boundary = found.hypotheses.is_active(Hypotheses::Family::boundary);
    const FitMode mode{.boundary = has_boundary ? BoundaryTest::at_once : BoundaryTest::none};
    Hypotheses nothing_released = found.hypotheses;
    nothing_released.readmit_all();
    FitState nominal = nominal_state(problem);
    nominal.slack = Assumed(problem, nothing_released).measured_slack(1.0);
    Explanation from = fit(problem, std::move(nothing_released), std::move(nominal));
    for (int count = 0; count < most; ++count) {
        const double before = found.cost;
        std::set<int> edges = to_supports_nearby(problem, found.hypotheses);
        if (from.is_sound()) {
            edges.merge(improbably_slack(problem, from));
        }
        for (const int edge : edges) {
            Explanation other = with_taut_edge(problem, from, edge, mode);
            if (other.cost < found.cost) {
                found = std::move(other);
            }
        }
        if (!(found.cost < before)) {
            break;
        }
        from = found;
    }
    return found;
}

Explanation with_clamps(const FitProblem& problem, Explanation found) {
    test_hypotheses(problem, found);
    Explanation best = found;
    bool has_changed = false;
    for (const int node : suspect_nodes(found.hypotheses)) {
        for (const int pair : pairs_at(node, best.hypotheses)) {
            if (std::optional<Explanation> other = instead_of(problem, best, pair)) {
                best = *std::move(other);
                has_changed = true;
                break;
            }
        }
    }
    if (has_changed) {
        best = fit(problem, std::move(best.hypotheses), std::move(best.at));
        if (best.is_sound()) {
            best = explain(problem, std::move(best.hypotheses), std::move(best.at));
        }
    }
    return best.is_sound() ? best : found;
}

}  // namespace taut
