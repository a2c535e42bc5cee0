// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/slack_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// What is more standard deviations away than this is not expected.
constexpr double reach = 3.0;

/// The length [m] that an edge has at least while it is taut.
double shortest_taut(const CableNet& net, int edge, const LengthLaw& law) {
    const bool is_adjustable = std::ranges::binary_search(net.adjustable_edges(), edge);
    return net.unstressed_lengths()(edge) - (is_adjustable ? 0.0 : reach * law.std());
}

/// Standard deviation [m] of the measured length of an edge; infinite where an end was not
/// measured.
double measured_std(const CableNet& net, const Knowledge& knowledge, int edge) {
    const auto [s, t] = net.edges()[edge];
    const Eigen::Vector3d u = (knowledge.form.col(s) - knowledge.form.col(t)).normalized();
    double variance = 0.0;
    for (const int node : {s, t}) {
        if (net.free_index(node) < 0) {
            continue;
        }
        if (!(knowledge.weights.col(node).minCoeff() > 0.0)) {
            return std::numeric_limits<double>::infinity();
        }
        variance += u.cwiseAbs2().cwiseQuotient(knowledge.weights.col(node)).sum();
    }
    return std::sqrt(variance);
}

}  // namespace

std::vector<bool> slack_by_form(const CableNet& net, const Guess& guess, const LengthLaw& law) {
    const Eigen::VectorXd lengths = edge_lengths(net, guess.form);
    std::vector<bool> slack(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        slack[e] = lengths(e) < shortest_taut(net, e, law);
    }
    return slack;
}

std::vector<bool> slack_by_survey(const CableNet& net, const Knowledge& knowledge,
                                  const LengthLaw& law) {
    const Eigen::VectorXd measured = edge_lengths(net, knowledge.form);
    std::vector<bool> slack(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        slack[e] =
            measured(e) + reach * measured_std(net, knowledge, e) < shortest_taut(net, e, law);
    }
    return slack;
}

std::vector<bool> where_measured(const CableNet& net, const Knowledge& knowledge,
                                 std::vector<bool> slack) {
    for (int e = 0; e < net.edge_count(); ++e) {
        slack[e] = slack[e] && std::isfinite(measured_std(net, knowledge, e));
    }
    return slack;
}

GaussNewtonResult fit_to_survey(const CableNet& net, ConditionedStatics& statics,
                                const Knowledge& knowledge, const LengthLaw& law,
                                const Guess& start, std::vector<bool> slack, double tolerance,
                                int max_iterations) {
    GaussNewtonResult fit;
    Guess from = start;
    std::vector<bool> taut_for_good(slack.size(), false);
    bool has_failed = false;
    // Few rounds do: which edges the form shows as slack changes little with the fit.
    constexpr int most_rounds = 12;
    for (int round = 0; round < most_rounds; ++round) {
        statics.set_slack(slack);
        fit = fit_under_statics(statics, knowledge, std::move(from), tolerance, max_iterations);
        const std::vector<bool> shown = slack_by_form(net, fit.guess, law);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that has not settled tells which edges led it astray, but no more.
            slack[e] = shown[e] && !taut_for_good[e] && (fit.converged || slack[e]);
        }
        if (slack == statics.slack() || (has_failed && !fit.converged)) {
            return fit;
        }
        has_failed = has_failed || !fit.converged;
        from = fit.converged ? fit.guess : start;
    }
    fit.converged = false;
    return fit;
}

}  // namespace taut
