// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/survey_fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "estimation/feasible_descent.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/slack_set.hpp"
#include "taut/numerical_error.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

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

/// A widened prior lets lengths explain everything: it cannot be tested.
bool tests_priors(const Survey& survey, const SurveyFitSettings& settings) {
    return survey.is_noisy() && settings.prior_width == 1.0;
}

/// The false alarm rate of all tests of the priors together: that of the targets.
double prior_alarm_rate(const Survey& survey, const SurveyFitSettings& settings) {
    return tests_priors(survey, settings) ? settings.false_alarm_rate : 0.0;
}

}  // namespace

SurveyFit::SurveyFit(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
                     const SurveyFitSettings& settings)
    : m_net(net),
      m_survey(with_supports(net, survey)),
      m_knowledge(knowledge),
      m_length_std(knowledge.length_std()),
      m_settings(checked(net, survey, knowledge, settings)),
      m_noise(with_noise_floor(net, m_survey)),
      m_tolerance(tolerance_in_noise * m_noise(Eigen::all, survey.surveyed).minCoeff()),
      m_statics(net, knowledge.uncertain, knowledge.frame_is_unknown, {}, knowledge.coupling()),
      m_snooping(net, m_survey, m_noise, m_knowledge.forces.measurements,
                 settings.false_alarm_rate),
      m_length_snooping(net, knowledge.priors, prior_alarm_rate(survey, settings)),
      m_boundary_snooping(net, knowledge.uncertain, prior_alarm_rate(survey, settings)) {
    m_statics.set_blur(blur_by(net, m_length_std, knowledge.uncertain));
}

Iterate SurveyFit::nominal() const {
    return nominal_iterate(m_net, m_statics.common().count());
}

std::vector<bool> SurveyFit::as_seen(std::vector<bool> slack) const {
    return m_knowledge.as_seen(std::move(slack), m_snooping.rejected_forces());
}

/// Edges (m) that a form shows to be slack, corrected by what was seen.
std::vector<bool> SurveyFit::shown_slack(const Iterate& iterate) const {
    const Eigen::VectorXd lengths =
        m_statics.common().cold(edge_lengths(m_net, iterate.form), iterate.common);
    return as_seen(slack_by_lengths(m_net, lengths, m_knowledge.priors));
}

/// Edges (m) that were measured to be slack, corrected by what was seen.
std::vector<bool> SurveyFit::measured_slack(double inflation) const {
    return as_seen(slack_by_survey(m_net, observations(inflation), m_knowledge.priors,
                                   m_statics.common().thermal_stds()));
}

GaussNewtonResult SurveyFit::run() {
    Mode last;
    GaussNewtonResult fitted = fit_and_snoop(nominal(), last);
    if (!is_sound(fitted)) {
        fitted = by_rounded_tension_laws();
    } else {
        if (m_boundary_snooping.is_active() && try_boundary(fitted)) {
            last.boundary = BoundaryTest::at_once;
        }
        if (m_length_snooping.is_active() && !suspect_nodes().empty()) {
            try_clamps(fitted);
        }
    }
    if (!fitted.converged) {
        m_statics.set_slack(as_seen(std::vector<bool>(m_net.edge_count(), false)));
        if (!m_statics.linearise(fitted.iterate, observations())) {
            throw NumericalError(
                "the statics of the net are singular at the surveyed form. Check the net and the "
                "prior");
        }
        m_statics.invert();
    }
    evaluate(fitted, last);
    m_cost = cost_of(fitted);
    m_contradicts_too_many = m_snooping.is_active() && m_snooping.contradicts_too_many();
    if (m_contradicts_too_many) {
        m_cost = std::numeric_limits<double>::infinity();
        m_snooping.reject_suspicious();
    }
    return fitted;
}

double SurveyFit::cost_of(const GaussNewtonResult& fitted) const {
    return fitted.converged ? 2.0 * m_statics.objective(observations(), fitted.iterate) +
                                  m_snooping.rejected_cost() + m_length_snooping.released_cost() +
                                  m_boundary_snooping.released_cost()
                            : std::numeric_limits<double>::infinity();
}

/// Above 0 at the nodes (n) of rejected targets and released edges.
Eigen::VectorXd SurveyFit::suspects() const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_net.node_count());
    for (int node = 0; node < m_net.node_count(); ++node) {
        result(node) = m_snooping.rejected()[node] ? 1.0 : 0.0;
    }
    const std::vector<bool> released = m_length_snooping.released();
    for (size_t i = 0; i < released.size(); ++i) {
        if (released[i]) {
            result(m_net.edges()[m_net.interior_edges()[i]][0]) = 1.0;
        }
    }
    return result;
}

/// (boundary): where the boundary may explain what was found, fits again with its outliers
/// released, first all at once, then one after another. Takes the fit of the lowest cost.
/// @return whether it was tried
bool SurveyFit::try_boundary(GaussNewtonResult& fitted) {
    evaluate(fitted, {.boundary = BoundaryTest::at_once});
    if (!m_boundary_snooping.is_suspicious(suspects())) {
        return false;
    }
    const Iterate start = fitted.iterate;
    const std::vector<bool> slack = m_statics.slack();
    Explanation best = explanation_of(fitted);
    for (const BoundaryTest test : {BoundaryTest::at_once, BoundaryTest::one_by_one}) {
        readmit_all();
        Explanation other = explanation_of(fit_and_snoop(start, slack, {.boundary = test}));
        if (other.cost < best.cost) {
            best = std::move(other);
        }
    }
    fitted = fit_as(best);
    if (!is_sound(fitted)) {  // as before
        readmit_all();
        fitted = fit_and_snoop(nominal(), {});
    }
    return true;
}

SurveyFit::Explanation SurveyFit::explanation_of(const GaussNewtonResult& fitted) const {
    const bool is_one = is_sound(fitted) && !m_boundary_snooping.releases_too_many();
    return {.cost = is_one ? cost_of(fitted) : std::numeric_limits<double>::infinity(),
            .rejected = m_snooping.all_rejected(),
            .lengths = m_length_snooping.suspects(),
            .boundary = m_boundary_snooping.released(),
            .iterate = fitted.iterate,
            .slack = m_statics.slack(),
            .target_statistics = m_snooping.statistics()};
}

/// Leaves out and releases what an explanation does.
void SurveyFit::take_over(const Explanation& explanation) {
    m_snooping.set_rejected(explanation.rejected);
    m_length_snooping.set_suspects(explanation.lengths);
    m_boundary_snooping.set_released(explanation.boundary);
    take_over_releases();
}

/// Fits again, with what an explanation leaves out and releases.
GaussNewtonResult SurveyFit::fit_as(const Explanation& explanation) {
    take_over(explanation);
    return fit(with_released(explanation.iterate), explanation.slack, {});
}

/// (slip): the nodes of rejected targets and released edges, those of the largest statistics first.
std::vector<int> SurveyFit::suspect_nodes() const {
    constexpr size_t most = 8;
    std::vector<std::pair<double, int>> nodes;
    for (const Outlier& outlier : m_snooping.outliers()) {
        nodes.emplace_back(outlier.statistic, outlier.node);
    }
    for (const LengthOutlier& outlier : m_length_snooping.outliers()) {
        if (outlier.node >= 0) {
            nodes.emplace_back(outlier.statistic, outlier.node);
            continue;
        }
        for (const int node : m_net.edges()[outlier.edge]) {
            nodes.emplace_back(outlier.statistic, node);
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

/// (slip): at each suspect node, fits again with a slipped clamp instead of what was found there,
/// and with the target left out. Takes the fit of the lowest cost. Where clamp and target cost
/// nearly the same, the survey does not separate them: the target is left out and both edges get
/// wide priors.
void SurveyFit::try_clamps(GaussNewtonResult& fitted) {
    // A target has two degrees of freedom more than a clamp: chi-squared exceeds this in 3 of
    // 1,000.
    constexpr double inseparable = 11.6;
    // A clamp has one degree of freedom more than a single edge: 1 of 100.
    constexpr double more_than_one_edge = 6.6;
    evaluate(fitted, {});
    const Explanation before = explanation_of(fitted);
    Explanation best = before;
    const auto tried = [&](int node, size_t place, bool is_target) {
        m_snooping.set_rejected(best.rejected);
        m_snooping.set_rejected(node, is_target);
        m_length_snooping.set_suspects(best.lengths);
        m_length_snooping.set_pair(place, !is_target);
        Explanation other = best;
        other.rejected = m_snooping.all_rejected();
        other.lengths = m_length_snooping.suspects();
        const LengthSuspect& pair = other.lengths[place];
        if (!is_target) {  // a shorter one that was taken for slack may be taut
            other.slack[m_net.interior_edges()[pair.edge]] = false;
            other.slack[m_net.interior_edges()[pair.other]] = false;
        }
        const GaussNewtonResult fit = fit_as(other);
        if (is_sound(fit)) {
            evaluate(fit, {});
        }
        return explanation_of(fit);
    };
    bool has_changed = false;
    for (const int node : suspect_nodes()) {
        const bool is_surveyed = std::ranges::binary_search(m_survey.surveyed, node);
        m_length_snooping.set_suspects(best.lengths);
        for (const size_t place : m_length_snooping.pairs_at(node)) {
            const bool is_in_place_of_edge = best.lengths[best.lengths[place].edge].is_released ||
                                             best.lengths[best.lengths[place].other].is_released;
            const bool is_released = best.lengths[place].is_released;
            const Explanation clamp = is_released ? best : tried(node, place, false);
            if (!(clamp.cost <
                  best.cost + (is_in_place_of_edge ? -more_than_one_edge : inseparable)) ||
                !m_length_snooping.is_slip(clamp.lengths[place])) {
                continue;
            }
            const Explanation target =
                best.rejected.targets[node] || !is_surveyed ? best : tried(node, place, true);
            if (target.rejected.targets[node] && std::abs(clamp.cost - target.cost) < inseparable) {
                best = clamp;
                best.lengths[place].is_beside_target = true;
                best.rejected.targets[node] = true;
                best.rejected.for_good(node) = target.target_statistics(node);
            } else if (!is_released && clamp.cost < std::min(best.cost, target.cost)) {
                best = clamp;
            } else {
                continue;
            }
            has_changed = true;
            break;
        }
    }
    fitted = fit_as(best);
    if (has_changed && is_sound(fitted)) {
        fitted = fit_and_snoop(fitted.iterate, m_statics.slack(), {});
    }
    if (!is_sound(fitted)) {
        fitted = fit_as(before);
    }
}

/// Fits with those edges slack that the fitted form shows to be slack. Whether an edge is taut is a
/// discrete question: a cable stretched by a hundredth of a millimetre when taut can sag by several
/// when slack, and no small steps lead from one fit to the other. So the slack set to begin with is
/// an argument. An edge that comes out longer than a slack edge can be stays taut, even with some
/// pressure, so that the sets do not cycle.
GaussNewtonResult SurveyFit::fit(const Iterate& start, std::vector<bool> slack, const Mode& mode) {
    const double inflation = mode.inflation;
    if (mode.is_rounded) {
        return fit_rounded(start, inflation);
    }
    m_statics.round_corners(0.0);
    const Observations observed = observations(inflation);
    GaussNewtonResult fitted;
    Iterate from = start;
    std::vector<bool> taut_for_good(slack.size(), false);
    bool has_failed = false;
    for (int round = 0; round < most_slack_sets; ++round) {
        m_statics.set_slack(slack);
        fitted = gauss_newton(m_statics, observed, std::move(from), inflation * m_tolerance,
                              m_settings.max_iterations, m_settings.progress);
        follow_tension_laws(fitted, observed, inflation);
        const std::vector<bool> shown = shown_slack(fitted.iterate);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that did not converge can only take edges out of the set.
            slack[e] = shown[e] && !taut_for_good[e] && (fitted.converged || slack[e]);
        }
        if (slack == m_statics.slack() || (has_failed && !fitted.converged)) {
            if (fitted.converged) {
                m_statics.invert();  // (covariance)
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
void SurveyFit::follow_tension_laws(GaussNewtonResult& fitted, const Observations& observed,
                                    double inflation) {
    const auto refit = [&](const LawBlur& blur) {
        m_statics.set_blur(blur);
        return gauss_newton(m_statics, observed, fitted.iterate, inflation * m_tolerance,
                            m_settings.max_iterations, m_settings.progress);
    };
    for (int round = 0; !m_statics.blur().empty() && round < most_blurs && fitted.converged;
         ++round) {
        m_statics.invert();
        const LawBlur before = m_statics.blur();
        const LawBlur found = m_statics.blur_found(fitted.iterate);
        if (found.agrees_with(before)) {
            return;
        }
        GaussNewtonResult sharper = refit(found);
        if (!sharper.converged) {
            fitted = refit(before);
            return;
        }
        fitted = std::move(sharper);
    }
}

/// (rounded-law): from the widest corner to one far below the noise. Later fits begin at the corner
/// reached before.
GaussNewtonResult SurveyFit::fit_rounded(const Iterate& start, double inflation) {
    const Observations observed = observations(inflation);
    const double last =
        std::min(widest_corner(),
                 corner_in_noise * inflation * m_noise(Eigen::all, m_survey.surveyed).minCoeff());
    m_statics.set_slack(as_seen(std::vector<bool>(m_net.edge_count(), false)));
    GaussNewtonResult fitted{.iterate = start};
    m_corner_width = std::max(m_corner_width, last);
    while (true) {
        const bool is_last = m_corner_width == last;
        m_statics.round_corners(m_corner_width);
        fitted = feasible_descent(m_statics, observed, std::move(fitted.iterate),
                                  is_last ? small_decrement : decrement_on_the_way, most_descents,
                                  m_settings.progress);
        if (is_last || !fitted.has_factor) {
            break;
        }
        m_corner_width = std::max(last, corner_factor * m_corner_width);
    }
    if (fitted.has_factor) {
        m_statics.invert();
    }
    m_statics.set_slack(shown_slack(fitted.iterate));
    return fitted;
}

/// The corner w of a net of mean stretch s at which slack edges carry the nominal tension with
/// lengths one standard deviation too long: T = EA/l_0 w^2 / std for e = -std, so s = w^2 / std.
double SurveyFit::widest_corner() const {
    const double stretch =
        (edge_lengths(m_net, m_net.nodes()) - m_net.unstressed_lengths()).cwiseMax(0.0).mean();
    return std::min(m_length_std, std::sqrt(stretch * m_length_std));
}

/// Fits, and repeats the fit until data snooping changes nothing more.
/// @param slack edges (m) to begin with
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, std::vector<bool> slack,
                                           const Mode& mode) {
    m_snooping.reopen();
    m_length_snooping.reopen();
    m_boundary_snooping.reopen();
    GaussNewtonResult fitted = fit(with_released(start), std::move(slack), mode);
    // A descent that was cut short shows the largest gross errors, too.
    const auto can_be_tested = [&] {
        return m_snooping.is_active() &&
               (fitted.converged || (mode.is_rounded && fitted.has_factor));
    };
    for (int revision = 0; can_be_tested() && revision < most_revisions; ++revision) {
        evaluate(fitted, mode);
        if (!revise(mode)) {
            break;
        }
        const bool has_too_many =
            m_snooping.rejects_too_many() || m_boundary_snooping.releases_too_many();
        fitted = fit(
            with_released(std::move(fitted.iterate)),
            as_seen(where_measured(m_net, observations(mode.inflation), m_statics.slack())), mode);
        if (has_too_many) {
            break;
        }
    }
    return fitted;
}

/// The same, beginning with the edges that were measured to be slack.
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, const Mode& mode) {
    return fit_and_snoop(start, measured_slack(mode.inflation), mode);
}

/// (continuation): fits with a large noise, then with less and less, each from the result before.
/// The less a survey binds the form, the farther a linearisation holds. The gross errors show one
/// after another, the largest first. Once some are rejected, a fit from the nominal net is tried.
GaussNewtonResult SurveyFit::from_coarse_to_fine(bool is_rounded) {
    readmit_all();
    m_corner_width = widest_corner();
    Iterate from = nominal();
    std::vector<bool> slack = as_seen(std::vector<bool>(m_net.edge_count(), false));
    const auto refine = [&](double inflation) {
        const Mode mode{.inflation = inflation, .is_rounded = is_rounded};
        GaussNewtonResult fitted = fit_and_snoop(from, mode);
        if (!fitted.converged) {
            fitted = fit_and_snoop(
                from, as_seen(where_measured(m_net, observations(inflation), slack)), mode);
        }
        if (fitted.converged) {
            from = fitted.iterate;
            slack = m_statics.slack();
        }
        return fitted;
    };
    for (double inflation = first_inflation(); inflation > 1.0; inflation *= continuation_factor) {
        const int rejected = m_snooping.rejected_count();
        refine(inflation);
        if (m_snooping.rejected_count() > rejected) {
            GaussNewtonResult direct = fit_and_snoop(nominal(), {.is_rounded = is_rounded});
            if (direct.converged && !m_snooping.rejects_too_many()) {
                return direct;
            }
        }
    }
    return refine(1.0);
}

/// Rounded tension laws need no slack set, which can cycle, and have no pressure, under which a net
/// can buckle; every step lowers the objective. Their result starts a fit with a slack set. The
/// first of these that converges is taken: that fit, a continuation with slack sets, the rounded
/// fit.
GaussNewtonResult SurveyFit::by_rounded_tension_laws() {
    readmit_all();
    m_corner_width = widest_corner();
    GaussNewtonResult rounded = fit_and_snoop(nominal(), {.is_rounded = true});
    const bool is_rounded_sound = is_sound(rounded);
    const Explanation found = explanation_of(rounded);
    if (is_rounded_sound) {
        GaussNewtonResult fitted = fit_and_snoop(rounded.iterate, shown_slack(rounded.iterate), {});
        if (is_sound(fitted)) {
            return fitted;
        }
    }
    GaussNewtonResult fitted = from_coarse_to_fine(false);
    if (is_sound(fitted)) {
        return fitted;
    }
    if (!is_rounded_sound) {
        return from_coarse_to_fine(true);
    }
    take_over(found);
    return fit_rounded(with_released(rounded.iterate), 1.0);
}

/// One step of data snooping: targets, force measurements, lengths and the boundary compete.
bool SurveyFit::revise(const Mode& mode) {
    if (mode.is_rounded) {
        return m_snooping.revise();
    }
    const Eigen::VectorXd of_targets = m_snooping.scores();
    const Eigen::VectorXd of_lengths = m_length_snooping.scores();
    const Eigen::VectorXd of_boundary = mode.boundary != BoundaryTest::none
                                            ? m_boundary_snooping.scores()
                                            : Eigen::VectorXd::Zero(m_net.node_count());
    const bool has_released = m_length_snooping.release(of_targets.cwiseMax(of_boundary));
    bool has_changed = m_snooping.reject(of_lengths.cwiseMax(of_boundary)) || has_released;
    // Gross errors elsewhere show at the boundary, too, and several boundary outliers show at many
    // targets: hence both orders are tried.
    const bool is_one_by_one = mode.boundary == BoundaryTest::one_by_one;
    if (mode.boundary == BoundaryTest::at_once || (is_one_by_one && !has_changed)) {
        const bool has_released_boundary =
            m_boundary_snooping.release(of_targets.cwiseMax(of_lengths), is_one_by_one);
        has_changed = has_changed || has_released_boundary;
    }
    if (!has_changed) {
        const bool has_readmitted = m_snooping.readmit();
        const bool has_readmitted_edge = m_length_snooping.readmit();
        has_changed = m_boundary_snooping.readmit() || has_readmitted || has_readmitted_edge;
    }
    if (m_length_snooping.releases_too_many()) {
        m_length_snooping.give_up();  // (length-snooping): the prior is wrong, not the edges
    }
    take_over_releases();
    return has_changed;
}

void SurveyFit::readmit_all() {
    m_snooping.readmit_all();
    m_length_snooping.readmit_all();
    m_boundary_snooping.readmit_all();
    take_over_releases();
}

/// Puts the released edges and boundary into the knowledge of the next fit.
void SurveyFit::take_over_releases() {
    m_knowledge.priors = m_length_snooping.priors();
    if (m_knowledge.released != m_boundary_snooping.released()) {
        m_knowledge.released = m_boundary_snooping.released();
        m_statics.set_released(m_knowledge.released);
    }
}

/// An iterate with the common parameters now released, at 0, and the supports moved accordingly.
Iterate SurveyFit::with_released(Iterate iterate) const {
    const CommonParameters& common = m_statics.common();
    Eigen::VectorXd values = Eigen::VectorXd::Zero(common.count());
    values.head(common.kept_count()) = iterate.common.head(common.kept_count());
    iterate.common = std::move(values);
    if (common.moves_supports() &&
        std_of(m_knowledge.uncertain, UncertainParameter::Kind::supports) <= 0.0) {
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
    Observations result = observe(m_net, m_survey, m_noise, m_snooping.rejected(), m_knowledge,
                                  m_statics.common().count());
    const std::vector<ForceMeasurement>& forces = m_knowledge.forces.measurements;
    for (size_t k = 0; k < forces.size(); ++k) {
        if (m_snooping.rejected_forces()[k]) {
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

void SurveyFit::evaluate(const GaussNewtonResult& fitted, const Mode& mode) {
    const double inflation = mode.inflation;
    m_snooping.evaluate(
        fitted.iterate.form, [this](int node) { return m_statics.form_covariance(node); },
        inflation);
    if (!m_knowledge.forces.measurements.empty()) {
        m_snooping.evaluate_forces(
            m_statics.tensions(fitted.iterate), m_statics.tension_variances(),
            [this](const Eigen::VectorXd& weights) {
                return m_statics.covariances_with(weights).dot(weights);
            },
            inflation);
    }
    if (mode.boundary != BoundaryTest::none && m_boundary_snooping.is_active()) {
        m_boundary_snooping.evaluate(m_statics, fitted.iterate, observations(inflation),
                                     m_snooping.residual_scale());
    }
    if (m_length_snooping.is_active() && !mode.is_rounded) {
        const Observations observed = observations(inflation);
        m_length_snooping.evaluate(
            length_likelihoods(m_net, m_knowledge, m_statics, observed, fitted.iterate), m_statics,
            observed, fitted.iterate);
    }
}

}  // namespace taut
