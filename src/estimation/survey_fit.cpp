// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/survey_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "estimation/boundary_tests.hpp"
#include "estimation/feasible_descent.hpp"
#include "estimation/gauss_newton.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/length_tests.hpp"
#include "estimation/slack_set.hpp"
#include "estimation/target_tests.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {
using Family = Hypotheses::Family;

/// The survey cannot show a step that moves nothing by more than this part of its smallest standard
/// deviation.
constexpr double tolerance_in_noise = 1e-3;

/// A few rounds suffice: the edges that the form shows as slack change little with the fit.
constexpr int most_slack_sets = 12;
constexpr int most_revisions = 100;
constexpr int most_blurs = 8;

/// (continuation): the noise is at first so large that no target is more than so many standard
/// deviations off, then smaller by this factor at each step.
constexpr double largest_misfit_at_first = 0.3;
constexpr double continuation_factor = 0.3;

/// (rounded-law): widths of the corner, in the smallest standard deviation of the survey at last,
/// and from one to the next; (decrement) at last and on the way there.
constexpr double corner_in_noise = 0.3;
constexpr double corner_factor = 0.3;
constexpr double small_decrement = 0.01;
constexpr double decrement_on_the_way = 0.3;
constexpr int most_descents = 60;

/// @return the settings, after all input of a fit was checked
SurveyFitSettings checked(const CableNet& net, const Survey& survey,
                          const PriorKnowledge& knowledge, const SurveyFitSettings& settings) {
    check_survey(net, survey);
    check_forces(net, knowledge.forces);
    for (const LengthPrior& prior : knowledge.priors) {
        prior.check();
    }
    if (settings.max_iterations < 1) {
        throw std::invalid_argument(
            fmt::format("max_iterations is {}, expected at least 1", settings.max_iterations));
    }
    if (!(settings.false_alarm_rate >= 0.0 && settings.false_alarm_rate < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "false_alarm_rate is {}, expected at least 0 and below 1", settings.false_alarm_rate));
    }
    return settings;
}

std::vector<Hypothesis> all_hypotheses(const CableNet& net, const Survey& survey,
                                       const PriorKnowledge& knowledge,
                                       const SurveyFitSettings& settings) {
    // A widened prior lets lengths explain everything: it cannot be tested.
    const bool tests_priors = survey.is_noisy() && settings.prior_width == 1.0;
    const double rate_of_priors = tests_priors ? settings.false_alarm_rate : 0.0;
    std::vector<Hypothesis> all =
        measurement_hypotheses(survey, knowledge.forces.measurements, settings.false_alarm_rate);
    std::ranges::copy(length_hypotheses(net, knowledge.priors, rate_of_priors),
                      std::back_inserter(all));
    std::ranges::copy(boundary_hypotheses(net, rate_of_priors), std::back_inserter(all));
    return all;
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

/// Whether anything is released, or above its threshold.
bool has_suspects(const Hypotheses& hypotheses) {
    using Family = Hypotheses::Family;
    const auto families = {Family::targets, Family::forces, Family::lengths, Family::boundary};
    return std::ranges::any_of(families, [&](Family family) {
        return hypotheses.released_count(family) + hypotheses.suspicious_count(family) > 0;
    });
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

}  // namespace

SurveyFit::SurveyFit(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
                     const SurveyFitSettings& settings)
    : m_net(net),
      m_survey(with_supports(net, survey)),
      m_priors(knowledge.priors),
      m_knowledge(knowledge),
      m_length_std(knowledge.length_std()),
      m_settings(checked(net, survey, knowledge, settings)),
      m_noise(with_noise_floor(net, m_survey)),
      m_tolerance(tolerance_in_noise * m_noise(Eigen::all, survey.surveyed).minCoeff()),
      m_model(net, knowledge.uncertain, knowledge.frame_is_unknown, knowledge.test_loads),
      m_hypotheses(net, all_hypotheses(net, m_survey, knowledge, settings)) {
    m_model.blur = blur_by(net, m_length_std, knowledge.uncertain);
    assume(m_hypotheses);
}

Iterate SurveyFit::nominal() const {
    return nominal_iterate(m_net, m_model.common.count());
}

std::vector<bool> SurveyFit::as_seen(std::vector<bool> slack) const {
    return m_knowledge.as_seen(std::move(slack), m_rejected_forces);
}

/// Edges (m) that a form shows to be slack, corrected by what was seen.
std::vector<bool> SurveyFit::shown_slack(const Iterate& iterate) const {
    const Eigen::VectorXd lengths =
        m_model.common.cold(edge_lengths(m_net, iterate.form), iterate.common);
    return as_seen(slack_by_lengths(m_net, lengths, m_knowledge.priors));
}

/// Edges (m) that were measured to be slack, corrected by what was seen.
std::vector<bool> SurveyFit::measured_slack(double inflation) const {
    return as_seen(slack_by_survey(m_net, observations(inflation), m_knowledge.priors,
                                   m_model.common.thermal_stds()));
}

LinearisedFit SurveyFit::run() {
    Mode last;
    Explanation best = explain(m_hypotheses, nominal(), last);  // (map), (snooping)
    if (!best.is_sound()) {
        best = by_rounded_tension_laws(std::move(best.hypotheses));  // (rounded-law)
    } else {
        if (best.hypotheses.is_active(Family::boundary)) {
            test(best, {.boundary = BoundaryTest::at_once});
            if (best.hypotheses.may_be_boundary()) {
                best = with_boundary(std::move(best));  // (boundary)
                last.boundary = BoundaryTest::at_once;
            }
        }
        if (best.is_sound() && has_suspects(best.hypotheses)) {
            best = with_taut_edges(std::move(best));  // (boundary)
        }
        if (best.hypotheses.released_count(Family::boundary) > 0) {
            last.boundary = BoundaryTest::at_once;
        }
        if (best.hypotheses.is_active(Family::lengths) && !suspect_nodes(best.hypotheses).empty()) {
            best = with_clamps(std::move(best));  // (slip)
        }
    }
    if (!best.fitted.converged) {
        m_model.slack = as_seen(std::vector<bool>(m_net.edge_count(), false));
        m_linearisation.reset();
        LinearisedFit there = linearised_fit(m_model, best.fitted.iterate, observations());
        m_linearisation = std::move(there.linearisation);
        m_covariance = std::move(there.covariance);
    }
    test(best, last);
    m_cost = best.cost;
    m_contradicts_too_many = best.hypotheses.is_active(Family::targets) &&
                             best.hypotheses.contradicts_too_many(Family::targets);
    if (m_contradicts_too_many) {
        m_cost = std::numeric_limits<double>::infinity();
        best.hypotheses.release_outliers(Suspect::target);
    }
    m_hypotheses = std::move(best.hypotheses);
    assume(m_hypotheses);
    m_converged = best.fitted.converged;
    return {std::move(best.fitted.iterate), *std::move(m_linearisation), std::move(m_covariance)};
}

/// Fits, and repeats the fit until data snooping changes nothing more.
/// @param slack edges (m) to begin with; empty: those that were measured to be slack
SurveyFit::Explanation SurveyFit::explain(Hypotheses hypotheses, const Iterate& start,
                                          const Mode& mode,
                                          std::optional<std::vector<bool>> slack) {
    hypotheses.reopen();
    assume(hypotheses);
    Explanation found = fit(std::move(hypotheses), start,
                            slack ? *std::move(slack) : measured_slack(mode.inflation), mode);
    // A descent that was cut short shows the largest gross errors, too.
    const auto can_be_tested = [&] {
        return found.hypotheses.is_active(Family::targets) &&
               (found.fitted.converged || (mode.is_rounded && m_linearisation));
    };
    for (int revision = 0; can_be_tested() && revision < most_revisions; ++revision) {
        test(found, mode);  // (snooping), (length-snooping), (slip), (boundary)
        if (!found.hypotheses.revise(mode.boundary)) {  // (score), (threshold)
            break;
        }
        const bool has_too_many = found.hypotheses.has_too_many(Family::targets) ||
                                  found.hypotheses.has_too_many(Family::boundary);
        assume(found.hypotheses);
        found =
            fit(std::move(found.hypotheses), found.fitted.iterate,
                as_seen(where_measured(m_net, observations(mode.inflation), found.slack)), mode);
        if (has_too_many) {
            break;
        }
    }
    return found;
}

/// Fits once, with what these hypotheses leave out and release.
/// @param slack edges (m) to begin with
SurveyFit::Explanation SurveyFit::fit(Hypotheses hypotheses, const Iterate& start,
                                      std::vector<bool> slack, const Mode& mode) {
    assume(hypotheses);
    Explanation result{
        .hypotheses = std::move(hypotheses),
        .fitted = mode.is_rounded
                      ? fit_rounded(with_released(start), mode.inflation)
                      : fit_with_slack_set(with_released(start), std::move(slack), mode.inflation),
        .slack = m_model.slack,
        .cost = std::numeric_limits<double>::infinity()};
    if (result.is_sound() && !result.hypotheses.has_too_many(Family::boundary)) {
        result.cost = 2.0 * m_model.objective(observations(), result.fitted.iterate) +
                      result.hypotheses.cost();
    }
    return result;
}

/// Puts what is left out and released into the knowledge of the next fit.
void SurveyFit::assume(const Hypotheses& hypotheses) {
    m_rejected = hypotheses.is_released(Suspect::target, m_net.node_count());
    m_rejected_forces = hypotheses.is_released(
        Suspect::force, static_cast<int>(m_knowledge.forces.measurements.size()));
    m_knowledge.priors = priors_with_released(hypotheses, m_net, m_priors);
    if (BoundaryReleases released = boundary_releases(hypotheses);
        m_model.common.released() != released) {
        m_model.common =
            CommonParameters(m_net, m_knowledge.uncertain, m_knowledge.frame_is_unknown,
                             m_knowledge.test_loads, std::move(released));
    }
}

/// The tests of all hypotheses at a fit, the last one made.
void SurveyFit::test(Explanation& found, const Mode& mode) const {
    Hypotheses& hypotheses = found.hypotheses;
    const Iterate& at = found.fitted.iterate;
    const std::vector<ForceMeasurement>& forces = m_knowledge.forces.measurements;
    const Observations observed = observations(mode.inflation);
    hypotheses.begin_tests();
    test_targets(
        hypotheses, m_survey, m_noise, at.form,
        [this](int node) { return m_covariance.places[node]; }, mode.inflation);
    if (!forces.empty()) {
        test_forces(
            hypotheses, forces, observed.measured(m_model.tensions(at), at.common),
            m_covariance.measured,
            [this](const Eigen::VectorXd& weights) {
                return m_linearisation->measured_variance(weights);
            },
            mode.inflation);
    }
    if (mode.boundary != BoundaryTest::none && hypotheses.is_active(Family::boundary)) {
        test_boundary(hypotheses, *m_linearisation, m_covariance, at, observed);
    }
    if (!mode.is_rounded && hypotheses.is_active(Family::lengths)) {
        test_lengths(hypotheses, m_net, m_priors,
                     length_likelihoods(m_knowledge, m_model, m_covariance, observed, at),
                     *m_linearisation, observed, at);
    }
}

/// (boundary): fits again with the outliers of the boundary released, first all at once, then one
/// after another. Gross errors elsewhere show at the boundary, too, and several boundary outliers
/// show at many targets: hence both orders are tried. Takes the fit of the lowest cost.
SurveyFit::Explanation SurveyFit::with_boundary(Explanation found) {
    const Explanation before = found;
    const Iterate start = found.fitted.iterate;
    const std::vector<bool> slack = found.slack;
    Hypotheses hypotheses = found.hypotheses;
    for (const BoundaryTest test : {BoundaryTest::at_once, BoundaryTest::one_by_one}) {
        hypotheses.readmit_all();
        Explanation other = explain(std::move(hypotheses), start, {.boundary = test}, slack);
        hypotheses = other.hypotheses;
        if (other.cost < found.cost) {
            found = std::move(other);
        }
    }
    found = fit(std::move(found.hypotheses), found.fitted.iterate, std::move(found.slack), {});
    return found.is_sound() ? found : fit(before.hypotheses, start, slack, {});
}

/// Slack edges that the form leaves more length than their priors have, the most first.
std::vector<int> SurveyFit::improbably_slack(const Explanation& found) const {
    constexpr size_t most = 8;
    constexpr double improbable = 2.0;  // standard deviations of the prior
    const std::vector<int>& marked = m_knowledge.forces.slack;
    std::vector<std::pair<double, int>> edges;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!found.slack[e] || std::ranges::find(marked, e) != marked.end()) {
            continue;
        }
        const Iterate& at = found.fitted.iterate;
        const auto [s, t] = m_net.edges()[e];
        const double unused =
            m_model.unstressed_length(e, at) - (at.form.col(s) - at.form.col(t)).norm();
        const auto interior = std::ranges::lower_bound(m_net.interior_edges(), e);
        const bool is_interior = interior != m_net.interior_edges().end() && *interior == e;
        const double std =
            is_interior ? m_priors[interior - m_net.interior_edges().begin()].std() : 0.0;
        if (unused > improbable * std) {
            edges.emplace_back(unused, e);
        }
    }
    std::ranges::sort(edges, std::greater());
    edges.resize(std::min(most, edges.size()));
    std::vector<int> result;
    std::ranges::transform(edges, std::back_inserter(result), &std::pair<double, int>::second);
    return result;
}

/// A fit with an edge released and taut, beside what is released already.
std::optional<SurveyFit::Explanation> SurveyFit::with_taut_edge(Explanation other, int edge,
                                                                const Mode& mode) {
    if (!other.hypotheses.release_edge(edge)) {
        return std::nullopt;
    }
    Explanation from_nominal = explain(other.hypotheses, nominal(), mode);
    if (from_nominal.is_sound() && !from_nominal.slack[edge]) {
        return from_nominal;
    }
    other.slack[edge] = false;
    return explain(std::move(other.hypotheses), other.fitted.iterate, mode, other.slack);
}

/// (boundary): an edge that is much too short pulls its run, and seems slack at the length that is
/// expected of it. So edges that are slack where nothing is released are tried one by one, taut and
/// instead of what was found; then others beside that. Takes the fit of the lowest cost.
SurveyFit::Explanation SurveyFit::with_taut_edges(Explanation found) {
    constexpr int most = 3;
    const Mode mode{.boundary = found.hypotheses.is_active(Family::boundary) ? BoundaryTest::at_once
                                                                             : BoundaryTest::none};
    const LawBlur blur = m_model.blur;
    Explanation from = found;
    from.hypotheses.readmit_all();
    from = fit(std::move(from.hypotheses), nominal(), measured_slack(1.0), {});
    Explanation best = found;
    for (int count = 0; count < most && from.is_sound(); ++count) {
        const double before = best.cost;
        assume(from.hypotheses);
        for (const int edge : improbably_slack(from)) {
            std::optional<Explanation> other = with_taut_edge(from, edge, mode);
            if (other && other->cost < best.cost) {
                best = *std::move(other);
            }
        }
        if (!(best.cost < before)) {
            break;
        }
        from = best;
    }
    best = fit(std::move(best.hypotheses), best.fitted.iterate, std::move(best.slack), {});
    if (!best.is_sound()) {  // as before
        m_model.blur = blur;
        best = fit(std::move(found.hypotheses), found.fitted.iterate, std::move(found.slack), {});
    }
    return best;
}

/// A fit with a pair released and the target at its node in use, or the other way round.
/// @param pair place among the pairs
SurveyFit::Explanation SurveyFit::with_pair(Explanation other, int pair, bool is_target) {
    Hypothesis& released = other.hypotheses.of(Suspect::pair)[pair];
    other.hypotheses.set_pair(released, !is_target);
    if (Hypothesis* target = other.hypotheses.find(Suspect::target, released.nodes[0])) {
        target->state = is_target ? Hypothesis::State::released : Hypothesis::State::in_use;
    }
    if (!is_target) {  // a shorter one that was taken for slack may be taut
        other.slack[m_net.interior_edges()[released.index]] = false;
        other.slack[m_net.interior_edges()[released.other]] = false;
    }
    other = fit(std::move(other.hypotheses), other.fitted.iterate, std::move(other.slack), {});
    if (other.is_sound()) {
        test(other, {});
    }
    return other;
}

/// (slip): a slipped clamp instead of what was found at its node, where that costs less. Where
/// clamp and target cost nearly the same, the survey does not separate them: the target is left out
/// and both edges get wide priors.
/// @param pair place among the pairs
std::optional<SurveyFit::Explanation> SurveyFit::instead_of(const Explanation& best, int pair) {
    // A target has two degrees of freedom more than a clamp: chi-squared exceeds this in 3 of
    // 1,000.
    constexpr double inseparable = 11.6;
    // A clamp has one degree of freedom more than a single edge: 1 of 100.
    constexpr double more_than_one_edge = 6.6;
    const Hypothesis before = best.hypotheses.of(Suspect::pair)[pair];
    const auto lengths = best.hypotheses.of(Suspect::length);
    const bool is_in_place_of_edge =
        lengths[before.index].is_released() || lengths[before.other].is_released();
    Explanation clamp = before.is_released() ? best : with_pair(best, pair, false);
    Hypothesis& slipped = clamp.hypotheses.of(Suspect::pair)[pair];
    if (!(clamp.cost < best.cost + (is_in_place_of_edge ? -more_than_one_edge : inseparable)) ||
        !is_slip(slipped, m_priors)) {
        return std::nullopt;
    }
    Hypothesis* at_node = clamp.hypotheses.find(Suspect::target, before.nodes[0]);
    double cost_of_target = best.cost;
    if (at_node != nullptr) {
        Explanation target = best;
        if (!target.hypotheses.find(Suspect::target, at_node->index)->is_released()) {
            target = with_pair(std::move(target), pair, true);
        }
        cost_of_target = target.cost;
        if (std::abs(clamp.cost - cost_of_target) < inseparable) {
            slipped.state = Hypothesis::State::released_for_good;
            at_node->state = Hypothesis::State::released_for_good;
            at_node->statistic = target.hypotheses.find(Suspect::target, at_node->index)->statistic;
            return clamp;
        }
    }
    if (!before.is_released() && clamp.cost < std::min(best.cost, cost_of_target)) {
        return clamp;
    }
    return std::nullopt;
}

/// (slip): tries a slipped clamp at each suspect node.
SurveyFit::Explanation SurveyFit::with_clamps(Explanation found) {
    test(found, {});
    Explanation best = found;
    bool has_changed = false;
    for (const int node : suspect_nodes(found.hypotheses)) {
        for (const int pair : pairs_at(node, best.hypotheses)) {
            if (std::optional<Explanation> other = instead_of(best, pair)) {
                best = *std::move(other);
                has_changed = true;
                break;
            }
        }
    }
    best = fit(std::move(best.hypotheses), best.fitted.iterate, std::move(best.slack), {});
    if (has_changed && best.is_sound()) {
        best = explain(std::move(best.hypotheses), best.fitted.iterate, {}, best.slack);
    }
    return best.is_sound()
               ? best
               : fit(std::move(found.hypotheses), found.fitted.iterate, std::move(found.slack), {});
}

/// Gauss-Newton steps under the model as it is.
SurveyFit::Fitted SurveyFit::search(const Iterate& start, const Observations& observed,
                                    double inflation) {
    GaussNewtonResult found =
        gauss_newton(m_model, observed, start, inflation * m_tolerance, m_settings.max_iterations,
                     m_settings.progress, std::move(m_linearisation));
    m_linearisation = std::move(found.linearisation);
    return {.iterate = std::move(found.iterate), .converged = found.converged};
}

/// Fits with those edges slack that the fitted form shows to be slack. Whether an edge is taut is a
/// discrete question: a cable stretched by a hundredth of a millimetre when taut can sag by several
/// when slack, and no small steps lead from one fit to the other. So the slack set to begin with is
/// an argument. An edge that comes out longer than a slack edge can be stays taut, even with some
/// pressure, so that the sets do not cycle.
SurveyFit::Fitted SurveyFit::fit_with_slack_set(const Iterate& start, std::vector<bool> slack,
                                                double inflation) {
    m_model.corner_width = 0.0;
    const Observations observed = observations(inflation);
    Fitted fitted;
    Iterate from = start;
    std::vector<bool> taut_for_good(slack.size(), false);
    bool has_failed = false;
    for (int round = 0; round < most_slack_sets; ++round) {
        m_model.slack = slack;
        fitted = search(from, observed, inflation);
        follow_tension_laws(fitted, observed, inflation);
        const std::vector<bool> shown = shown_slack(fitted.iterate);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that did not converge can only take edges out of the set.
            slack[e] = shown[e] && !taut_for_good[e] && (fitted.converged || slack[e]);
        }
        if (slack == m_model.slack || (has_failed && !fitted.converged)) {
            if (fitted.converged) {
                m_covariance = m_linearisation->covariance();  // (covariance)
            }
            return fitted;
        }
        has_failed = has_failed || !fitted.converged;
        from = fitted.converged ? fitted.iterate : start;
    }
    fitted.converged = false;
    return fitted;
}

/// (blurred-law): fits again with the tension laws blurred by the strains' standard deviations at
/// the fit. Where that does not converge, the fit with the wider blur stands.
void SurveyFit::follow_tension_laws(Fitted& fitted, const Observations& observed,
                                    double inflation) {
    const auto refit = [&](const LawBlur& blur) {
        m_model.blur = blur;
        return search(fitted.iterate, observed, inflation);
    };
    for (int round = 0; !m_model.blur.empty() && round < most_blurs && fitted.converged; ++round) {
        const LawBlur before = m_model.blur;
        const LawBlur found =
            blur_found(m_model, m_linearisation->covariance(), fitted.iterate, observed);
        if (found.agrees_with(before)) {
            return;
        }
        Fitted sharper = refit(found);
        if (!sharper.converged) {
            fitted = refit(before);
            return;
        }
        fitted = std::move(sharper);
    }
}

/// (rounded-law): from the widest corner to one far below the noise. Later fits begin at the corner
/// reached before.
SurveyFit::Fitted SurveyFit::fit_rounded(const Iterate& start, double inflation) {
    const Observations observed = observations(inflation);
    const double last =
        std::min(widest_corner(),
                 corner_in_noise * inflation * m_noise(Eigen::all, m_survey.surveyed).minCoeff());
    m_model.slack = as_seen(std::vector<bool>(m_net.edge_count(), false));
    Fitted fitted{.iterate = start};
    m_corner_width = std::max(m_corner_width, last);
    while (true) {
        const bool is_last = m_corner_width == last;
        m_model.corner_width = m_corner_width;
        GaussNewtonResult found =
            feasible_descent(m_model, observed, std::move(fitted.iterate),
                             is_last ? small_decrement : decrement_on_the_way, most_descents,
                             m_settings.progress, std::move(m_linearisation));
        m_linearisation = std::move(found.linearisation);
        fitted = {.iterate = std::move(found.iterate), .converged = found.converged};
        if (is_last || !m_linearisation) {
            break;
        }
        m_corner_width = std::max(last, corner_factor * m_corner_width);
    }
    m_model.slack = shown_slack(fitted.iterate);
    if (m_linearisation) {
        m_covariance = m_linearisation->covariance();
        m_linearisation = (*std::move(m_linearisation)).under(m_model);
    }
    return fitted;
}

/// The corner w of a net of mean stretch s at which slack edges carry the nominal tension with
/// lengths one standard deviation too long: T = EA/l_0 w^2 / std for e = -std, so s = w^2 / std.
double SurveyFit::widest_corner() const {
    return std::min(m_length_std, std::sqrt(mean_stretch(m_net) * m_length_std));
}

/// (continuation): fits with a large noise, then with less and less, each from the result before.
/// The less a survey binds the form, the farther a linearisation holds. The gross errors show one
/// after another, the largest first. Once some are rejected, a fit from the nominal net is tried.
SurveyFit::Explanation SurveyFit::from_coarse_to_fine(Hypotheses hypotheses, bool is_rounded) {
    hypotheses.readmit_all();
    assume(hypotheses);
    m_corner_width = widest_corner();
    Iterate from = nominal();
    std::vector<bool> slack = as_seen(std::vector<bool>(m_net.edge_count(), false));
    const auto refine = [&](double inflation) {
        const Mode mode{.inflation = inflation, .is_rounded = is_rounded};
        Explanation found = explain(std::move(hypotheses), from, mode);
        if (!found.fitted.converged) {
            found = explain(std::move(found.hypotheses), from, mode,
                            as_seen(where_measured(m_net, observations(inflation), slack)));
        }
        if (found.fitted.converged) {
            from = found.fitted.iterate;
            slack = found.slack;
        }
        hypotheses = found.hypotheses;
        return found;
    };
    for (double inflation = first_inflation(); inflation > 1.0; inflation *= continuation_factor) {
        const int rejected = hypotheses.released_count(Family::targets);
        refine(inflation);
        if (hypotheses.released_count(Family::targets) > rejected) {
            Explanation direct =
                explain(std::move(hypotheses), nominal(), {.is_rounded = is_rounded});
            if (direct.is_sound()) {
                return direct;
            }
            hypotheses = std::move(direct.hypotheses);
        }
    }
    return refine(1.0);
}

/// Rounded tension laws need no slack set, which can cycle, and have no pressure, under which a net
/// can buckle; every step lowers the objective. Their result starts a fit with a slack set. The
/// first of these that converges is taken: that fit, a continuation with slack sets, the rounded
/// fit.
SurveyFit::Explanation SurveyFit::by_rounded_tension_laws(Hypotheses hypotheses) {
    hypotheses.readmit_all();
    m_corner_width = widest_corner();
    const Explanation rounded = explain(std::move(hypotheses), nominal(), {.is_rounded = true});
    Hypotheses last = rounded.hypotheses;
    if (rounded.is_sound()) {
        Explanation found = explain(std::move(last), rounded.fitted.iterate, {},
                                    shown_slack(rounded.fitted.iterate));
        if (found.is_sound()) {
            return found;
        }
        last = std::move(found.hypotheses);
    }
    Explanation found = from_coarse_to_fine(std::move(last), false);
    if (found.is_sound()) {
        return found;
    }
    if (!rounded.is_sound()) {
        return from_coarse_to_fine(std::move(found.hypotheses), true);
    }
    return fit(rounded.hypotheses, rounded.fitted.iterate, {}, {.is_rounded = true});
}

/// An iterate with the common parameters now released, at 0, and the supports moved accordingly.
Iterate SurveyFit::with_released(Iterate iterate) const {
    const CommonParameters& common = m_model.common;
    Eigen::VectorXd values = Eigen::VectorXd::Zero(common.count());
    values.head(common.kept_count()) = iterate.common.head(common.kept_count());
    iterate.common = std::move(values);
    if (!m_model.are_supports_uncertain()) {
        const Points motion = common.support_motion(iterate.common);
        for (const int node : m_net.supports()) {
            iterate.form.col(node) = m_net.nodes().col(node) + motion.col(node);
        }
    }
    return iterate;
}

double SurveyFit::first_inflation() const {
    const Points misfit = (m_survey.form - m_net.nodes()).cwiseQuotient(m_noise);
    return misfit(Eigen::all, m_survey.surveyed).cwiseAbs().maxCoeff() / largest_misfit_at_first;
}

Observations SurveyFit::observations(double inflation) const {
    Observations result =
        observe(m_net, m_survey, m_noise, m_rejected, m_knowledge, m_model.common.count());
    const std::vector<ForceMeasurement>& forces = m_knowledge.forces.measurements;
    for (size_t k = 0; k < forces.size(); ++k) {
        if (m_rejected_forces[k]) {
            result.tension_weights(forces[k].edge) = 0.0;
        }
    }
    result.variance *= m_settings.prior_width * m_settings.prior_width;
    const double squared_inflation = inflation * inflation;
    for (const int node : m_net.free_nodes()) {
        result.scale_weight(node, 1.0 / squared_inflation);
    }
    result.tension_weights /= squared_inflation;
    return result;
}

std::vector<Outlier> SurveyFit::outliers() const {
    return target_outliers(m_hypotheses, m_survey, m_noise);
}

std::vector<ForceOutlier> SurveyFit::force_outliers() const {
    return taut::force_outliers(m_hypotheses, m_knowledge.forces.measurements);
}

std::vector<LengthOutlier> SurveyFit::length_outliers() const {
    return taut::length_outliers(m_hypotheses, m_net, m_priors);
}

double SurveyFit::detectable_length(const std::vector<int>& edges) const {
    return taut::detectable_length(m_hypotheses, m_net, m_priors, edges);
}

}  // namespace taut
