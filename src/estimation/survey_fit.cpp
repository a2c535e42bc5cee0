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
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// A step that moves nothing by more than this part of the smallest standard deviation of the
/// survey changes nothing that the survey could show.
constexpr double tolerance_in_noise = 1e-3;

/// Few rounds do: which edges the form shows as slack changes little with the fit.
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

/// @return the settings, once all is checked that a fit is made of
SurveyFitSettings checked(const CableNet& net, const Survey& survey,
                          const PriorKnowledge& knowledge, const SurveyFitSettings& settings) {
    check_survey(net, survey);
    check_forces(net, knowledge.forces);
    for (const LengthLaw& law : knowledge.laws) {
        law.check();
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

/// One false alarm in all tests together, as seldom as among the targets. A wide prior is no law.
double length_threshold(const Survey& survey, const PriorKnowledge& knowledge,
                        const SurveyFitSettings& settings) {
    const bool is_tested = survey.is_noisy() && settings.prior_width == 1.0;
    return snooping_threshold(is_tested ? settings.false_alarm_rate : 0.0, knowledge.laws.size(),
                              1);
}

}  // namespace

SurveyFit::SurveyFit(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
                     const SurveyFitSettings& settings)
    : m_net(net),
      m_survey(with_supports(net, survey, knowledge)),
      m_knowledge(knowledge),
      m_length_std(knowledge.length_std()),
      m_settings(checked(net, survey, knowledge, settings)),
      m_noise(with_noise_floor(net, m_survey)),
      m_tolerance(tolerance_in_noise * m_noise(Eigen::all, survey.surveyed).minCoeff()),
      m_statics(net, knowledge.unknowns, knowledge.frame_is_unknown),
      m_snooping(net, m_survey, m_noise, m_knowledge.forces.readings, settings.false_alarm_rate),
      m_length_snooping(net, knowledge.laws, length_threshold(survey, knowledge, settings)) {
    m_statics.set_blur(blur_by(net, m_length_std, knowledge.unknowns));
}

Iterate SurveyFit::nominal() const {
    return nominal_iterate(m_net, m_statics.common().count());
}

std::vector<bool> SurveyFit::as_seen(std::vector<bool> slack) const {
    return m_knowledge.as_seen(std::move(slack), m_snooping.rejected_readings());
}

/// Edges (m) that a form shows to be slack, and no one saw taut.
std::vector<bool> SurveyFit::shown_slack(const Iterate& iterate) const {
    const Eigen::VectorXd lengths =
        m_statics.common().cold(edge_lengths(m_net, iterate.form), iterate.common);
    return as_seen(slack_by_lengths(m_net, lengths, m_knowledge.laws));
}

/// Edges (m) that were measured so.
std::vector<bool> SurveyFit::measured_slack(double inflation) const {
    return as_seen(slack_by_survey(m_net, observations(inflation), m_knowledge.laws,
                                   m_statics.common().thermal_stds()));
}

GaussNewtonResult SurveyFit::run() {
    GaussNewtonResult fitted = fit_and_snoop(nominal(), 1.0);
    if (!is_settled(fitted)) {
        fitted = by_rounded_laws();
    }
    if (!fitted.converged) {
        m_statics.set_slack(as_seen(std::vector<bool>(m_net.edge_count(), false)));
        if (!m_statics.linearise(fitted.iterate, observations())) {
            throw std::runtime_error(
                "the statics of the net are singular at the surveyed form: are net and law right?");
        }
        m_statics.invert();
    }
    evaluate(fitted, 1.0);
    m_cost = fitted.converged ? 2.0 * m_statics.objective(observations(), fitted.iterate) +
                                    m_snooping.rejected_cost() + m_length_snooping.released_cost()
                              : std::numeric_limits<double>::infinity();
    m_contradicts_too_many = m_snooping.is_active() && m_snooping.contradicts_too_many();
    if (m_contradicts_too_many) {
        m_cost = std::numeric_limits<double>::infinity();
    }
    if (m_contradicts_too_many) {
        m_snooping.reject_suspicious();
    }
    return fitted;
}

/// Fits with the edges slack that the fitted form shows to be so. Whether an edge is taut is a
/// question of its own: a cable that is stretched by a hundredth of a millimetre where it is taut
/// can hang by several where it is slack, and no small steps lead from one fit to the other. So the
/// start is told, and an edge that comes out longer than it can be while slack is taut for good,
/// even with some pressure: it stands between the two.
GaussNewtonResult SurveyFit::fit(const Iterate& start, std::vector<bool> slack, double inflation) {
    if (m_is_rounded) {
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
                              m_settings.max_iterations);
        follow_laws(fitted, observed, inflation);
        const std::vector<bool> shown = shown_slack(fitted.iterate);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that has not settled tells which edges led it astray, but no more.
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

/// (blurred-law): fits again with tension laws as the strains found so far show them. Where that
/// does not settle, what was found with the wider blur stands.
void SurveyFit::follow_laws(GaussNewtonResult& fitted, const Observations& observed,
                            double inflation) {
    const auto refit = [&](const LawBlur& blur) {
        m_statics.set_blur(blur);
        return gauss_newton(m_statics, observed, fitted.iterate, inflation * m_tolerance,
                            m_settings.max_iterations);
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

/// (rounded-law): from the widest corner to one that is lost in the noise. Later fits begin where
/// the corner is already.
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
                                  is_last ? small_decrement : decrement_on_the_way, most_descents);
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

/// The corner that makes a net of mean stretch s as tense as it is only by lengths of one standard
/// deviation of the law more: s = w^2 / std.
double SurveyFit::widest_corner() const {
    const double stretch =
        (edge_lengths(m_net, m_net.nodes()) - m_net.unstressed_lengths()).cwiseMax(0.0).mean();
    return std::min(m_length_std, std::sqrt(stretch * m_length_std));
}

/// Fits, and again with other targets rejected until data snooping has no more to say.
/// @param slack edges (m) to begin with
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, std::vector<bool> slack,
                                           double inflation) {
    m_snooping.reopen();
    m_length_snooping.reopen();
    GaussNewtonResult fitted = fit(start, std::move(slack), inflation);
    // A descent that was cut short tells the largest gross errors, too.
    const auto can_be_tested = [&] {
        return m_snooping.is_active() && (fitted.converged || (m_is_rounded && fitted.has_factor));
    };
    for (int revision = 0; can_be_tested() && revision < most_revisions; ++revision) {
        evaluate(fitted, inflation);
        if (!revise() || m_snooping.rejects_too_many()) {
            break;
        }
        fitted = fit(fitted.iterate,
                     as_seen(where_measured(m_net, observations(inflation), m_statics.slack())),
                     inflation);
    }
    return fitted;
}

/// The same, begun with the edges slack that were measured so.
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, double inflation) {
    return fit_and_snoop(start, measured_slack(inflation), inflation);
}

/// (continuation): as if the noise were large, then less and less, each fit from where the one
/// before ended. The less a survey binds the form, the farther a linearisation holds; and the gross
/// errors that led it astray show one after the other, the largest first. As soon as some were
/// rejected, a fit from the nominal net is tried.
GaussNewtonResult SurveyFit::from_coarse_to_fine() {
    readmit_all();
    m_corner_width = widest_corner();
    Iterate settled = nominal();
    std::vector<bool> slack = as_seen(std::vector<bool>(m_net.edge_count(), false));
    const auto refine = [&](double inflation) {
        GaussNewtonResult fitted = fit_and_snoop(settled, inflation);
        if (!fitted.converged) {
            fitted = fit_and_snoop(
                settled, as_seen(where_measured(m_net, observations(inflation), slack)), inflation);
        }
        if (fitted.converged) {
            settled = fitted.iterate;
            slack = m_statics.slack();
        }
        return fitted;
    };
    for (double inflation = first_inflation(); inflation > 1.0; inflation *= continuation_factor) {
        const int rejected = m_snooping.rejected_count();
        refine(inflation);
        if (m_snooping.rejected_count() > rejected) {
            GaussNewtonResult direct = fit_and_snoop(nominal(), 1.0);
            if (direct.converged && !m_snooping.rejects_too_many()) {
                return direct;
            }
        }
    }
    return refine(1.0);
}

/// No slack sets, which can cycle, and no pressure, under which a net can buckle; every step lowers
/// the objective. What it finds is a start for the fit with a slack set, whose result is taken
/// where that settles; else that of a continuation with slack sets; else the rounded one.
GaussNewtonResult SurveyFit::by_rounded_laws() {
    readmit_all();
    m_corner_width = widest_corner();
    GaussNewtonResult rounded = without_slack_set([&] { return fit_and_snoop(nominal(), 1.0); });
    const bool is_rounded_settled = is_settled(rounded);
    const DataSnooping::Rejected rejected = m_snooping.all_rejected();
    const std::vector<bool> released = m_length_snooping.released();
    if (is_rounded_settled) {
        GaussNewtonResult fitted =
            fit_and_snoop(rounded.iterate, shown_slack(rounded.iterate), 1.0);
        if (is_settled(fitted)) {
            return fitted;
        }
    }
    GaussNewtonResult fitted = from_coarse_to_fine();
    if (is_settled(fitted)) {
        return fitted;
    }
    if (!is_rounded_settled) {
        return without_slack_set([this] { return from_coarse_to_fine(); });
    }
    m_snooping.set_rejected(rejected);
    release(released);
    return fit_rounded(rounded.iterate, 1.0);
}

/// One step of data snooping: targets, readings and lengths stand against each other.
bool SurveyFit::revise() {
    const Eigen::VectorXd of_lengths = m_length_snooping.scores();
    const bool has_released = m_length_snooping.release(m_snooping.scores());
    bool has_changed = m_snooping.reject(of_lengths) || has_released;
    if (!has_changed) {
        const bool has_readmitted = m_snooping.readmit();
        has_changed = m_length_snooping.readmit() || has_readmitted;
    }
    if (m_length_snooping.releases_too_many()) {
        m_length_snooping.give_up();  // (length-snooping): not so many are mis-cut
    }
    m_knowledge.laws = m_length_snooping.laws();
    return has_changed;
}

void SurveyFit::readmit_all() {
    m_snooping.readmit_all();
    release(std::vector<bool>(m_knowledge.laws.size(), false));
}

/// These edges, and no others.
void SurveyFit::release(std::vector<bool> edges) {
    m_length_snooping.set_released(std::move(edges));
    m_knowledge.laws = m_length_snooping.laws();
}

double SurveyFit::first_inflation() const {
    const Points misfit = (m_survey.form - m_net.nodes()).cwiseQuotient(m_noise);
    return misfit(Eigen::all, m_survey.surveyed).cwiseAbs().maxCoeff() / largest_misfit_at_first;
}

Observations SurveyFit::observations(double inflation) const {
    Observations result = observe(m_net, m_survey, m_noise, m_snooping.rejected(), m_knowledge,
                                  m_statics.common().count());
    const std::vector<ForceReading>& readings = m_knowledge.forces.readings;
    for (size_t k = 0; k < readings.size(); ++k) {
        if (m_snooping.rejected_readings()[k]) {
            result.tension_weights(readings[k].edge) = 0.0;
        }
    }
    result.variance *= m_settings.prior_width * m_settings.prior_width;
    const double squared_inflation = inflation * inflation;
    for (const int node : m_net.free_nodes()) {
        result.weights.col(node) /= squared_inflation;
    }
    result.tension_weights /= squared_inflation;
    return result;
}

void SurveyFit::evaluate(const GaussNewtonResult& fitted, double inflation) {
    m_snooping.evaluate(
        fitted.iterate.form, [this](int node) { return m_statics.form_covariance(node); },
        inflation);
    if (!m_knowledge.forces.readings.empty()) {
        m_snooping.evaluate_readings(
            m_statics.tensions(fitted.iterate), m_statics.tension_variances(),
            [this](const Eigen::VectorXd& weights) {
                return m_statics.covariances_with(weights).dot(weights);
            },
            inflation);
    }
    if (m_length_snooping.is_active() && !m_is_rounded) {
        m_length_snooping.evaluate(length_likelihoods(m_net, m_knowledge, m_statics,
                                                      observations(inflation), fitted.iterate));
    }
}

}  // namespace taut
