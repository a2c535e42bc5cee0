// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/survey_fit.hpp"

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

#include "estimation/slack_set.hpp"

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

/// @return the settings, once all is checked that a fit is made of
SurveyFitSettings checked(const CableNet& net, const Survey& survey, const LengthLaw& law,
                          const SurveyFitSettings& settings) {
    check_survey(net, survey);
    law.check();
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

}  // namespace

SurveyFit::SurveyFit(const CableNet& net, const Survey& survey, const LengthLaw& law,
                     const SurveyFitSettings& settings)
    : m_net(net),
      m_survey(survey),
      m_law(law),
      m_settings(checked(net, survey, law, settings)),
      m_noise(with_noise_floor(net, survey)),
      m_tolerance(tolerance_in_noise * m_noise(Eigen::all, survey.surveyed).minCoeff()),
      m_statics(net),
      m_snooping(net, survey, m_noise, settings.false_alarm_rate) {
    m_statics.set_blur(blur_by(net, law.std()));
}

GaussNewtonResult SurveyFit::run() {
    GaussNewtonResult fitted = fit_and_snoop(nominal_iterate(m_net), 1.0);
    if (!fitted.converged || m_snooping.rejects_too_many()) {
        fitted = from_coarse_to_fine();
    }
    evaluate(fitted, 1.0);
    m_contradicts_too_many = m_snooping.is_active() && m_snooping.contradicts_too_many();
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
        const std::vector<bool> shown = slack_by_form(m_net, fitted.iterate, m_law);
        for (size_t e = 0; e < slack.size(); ++e) {
            taut_for_good[e] = taut_for_good[e] || (slack[e] && !shown[e]);
            // A search that has not settled tells which edges led it astray, but no more.
            slack[e] = shown[e] && !taut_for_good[e] && (fitted.converged || slack[e]);
        }
        if (slack == m_statics.slack() || (has_failed && !fitted.converged)) {
            m_statics.invert();  // (covariance)
            return fitted;
        }
        has_failed = has_failed || !fitted.converged;
        from = fitted.converged ? fitted.iterate : start;
    }
    fitted.converged = false;
    m_statics.invert();
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
    for (int round = 0; !m_net.is_linear() && round < most_blurs && fitted.converged; ++round) {
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

/// Fits, and again with other targets rejected until data snooping has no more to say.
/// @param slack edges (m) to begin with
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, std::vector<bool> slack,
                                           double inflation) {
    m_snooping.reopen();
    GaussNewtonResult fitted = fit(start, std::move(slack), inflation);
    for (int revision = 0; m_snooping.is_active() && fitted.converged && revision < most_revisions;
         ++revision) {
        evaluate(fitted, inflation);
        if (!m_snooping.revise() || m_snooping.rejects_too_many()) {
            break;
        }
        fitted = fit(fitted.iterate,
                     where_measured(m_net, observations(inflation), m_statics.slack()), inflation);
    }
    return fitted;
}

/// The same, begun with the edges slack that were measured so.
GaussNewtonResult SurveyFit::fit_and_snoop(const Iterate& start, double inflation) {
    return fit_and_snoop(start, slack_by_survey(m_net, observations(inflation), m_law), inflation);
}

/// (continuation): as if the noise were large, then less and less, each fit from where the one
/// before ended. The less a survey binds the form, the farther a linearisation holds; and the gross
/// errors that led it astray show one after the other, the largest first. As soon as some were
/// rejected, a fit from the nominal net is tried.
GaussNewtonResult SurveyFit::from_coarse_to_fine() {
    m_snooping.readmit_all();
    Iterate settled = nominal_iterate(m_net);
    std::vector<bool> slack(m_net.edge_count(), false);
    const auto refine = [&](double inflation) {
        GaussNewtonResult fitted = fit_and_snoop(settled, inflation);
        if (!fitted.converged) {
            fitted = fit_and_snoop(settled, where_measured(m_net, observations(inflation), slack),
                                   inflation);
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
            GaussNewtonResult direct = fit_and_snoop(nominal_iterate(m_net), 1.0);
            if (direct.converged && !m_snooping.rejects_too_many()) {
                return direct;
            }
        }
    }
    return refine(1.0);
}

double SurveyFit::first_inflation() const {
    const Points misfit = (m_survey.form - m_net.nodes()).cwiseQuotient(m_noise);
    return misfit(Eigen::all, m_survey.surveyed).cwiseAbs().maxCoeff() / largest_misfit_at_first;
}

Observations SurveyFit::observations(double inflation) const {
    Observations result = observe(m_net, m_survey, m_noise, m_snooping.rejected(),
                                  m_settings.prior_width * m_law.std());
    result.weights /= inflation * inflation;
    return result;
}

void SurveyFit::evaluate(const GaussNewtonResult& fitted, double inflation) {
    m_snooping.evaluate(
        fitted.iterate.form, [this](int node) { return m_statics.form_covariance(node); },
        inflation);
}

}  // namespace taut
