// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/maximum_a_posteriori.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "estimation/data_snooping.hpp"
#include "estimation/observations.hpp"
#include "estimation/slack_set.hpp"
#include "identification/exact_balance.hpp"
#include "identification/outcome.hpp"

namespace taut {
namespace {

/// A step that moves nothing by more than this part of the smallest standard deviation of the
/// survey changes nothing that the survey could show.
constexpr double tolerance_in_noise = 1e-3;

constexpr int most_revisions = 100;

/// Where the search does not settle, it goes there in steps: as if the survey's noise were so much
/// larger that no target were more than so many standard deviations off, then ever less, each from
/// where the one before ended. The less a survey binds the form, the farther a linearisation holds;
/// and the gross errors that led it astray show one after the other, the largest first.
constexpr double largest_misfit_at_first = 0.3;
constexpr double smaller = 0.3;

void check(const MaximumAPosterioriSettings& settings) {
    if (settings.max_iterations < 1) {
        throw std::invalid_argument(
            fmt::format("max_iterations is {}, expected at least 1", settings.max_iterations));
    }
    if (!(settings.false_alarm_rate >= 0.0 && settings.false_alarm_rate < 1.0)) {
        throw std::invalid_argument(fmt::format(
            "false_alarm_rate is {}, expected at least 0 and below 1", settings.false_alarm_rate));
    }
}

/// One identification: net, survey and law, and what the rounds of it share.
class Search {
public:
    Search(const CableNet& net, const Survey& survey, const LengthLaw& law,
           const MaximumAPosterioriSettings& settings)
        : m_net(net),
          m_survey(survey),
          m_law(law),
          m_settings(settings),
          m_noise(reckoned_noise(net, survey)),
          m_tolerance(tolerance_in_noise * m_noise(Eigen::all, survey.surveyed).minCoeff()),
          m_statics(net),
          m_test(net, survey, m_noise, settings.false_alarm_rate) {}

    Identification run() {
        const Guess nominal{.form = m_net.nodes(),
                            .deviations = Eigen::VectorXd::Zero(m_net.interior_edge_count())};
        GaussNewtonResult fitted = fit_and_test(nominal, 1.0);
        if (!fitted.converged || is_too_many(m_test.left_out_count())) {
            fitted = from_coarse_to_fine(nominal);
        }
        m_test.evaluate(m_statics, fitted.guess.form);
        Identification result{.method = "map"};
        if (is_testing() && is_too_many(m_test.left_out_count() + m_test.suspicious_count())) {
            result.status = IdentificationStatus::survey_does_not_fit;
            m_test.leave_out_suspicious();
        } else if (!fitted.converged) {
            result.status = IdentificationStatus::iteration_limit;
        }
        result.outliers = m_test.outliers();
        result.outlier_threshold = m_test.threshold();
        result.noise_ratio = m_test.noise_ratio();
        complete(result, m_net, m_survey, m_law,
                 likelihoods(m_net, m_statics, knowledge(1.0), fitted.guess), fitted.guess.form);
        return result;
    }

private:
    /// An exact survey has no noise to measure errors by.
    [[nodiscard]] bool is_testing() const {
        return m_settings.false_alarm_rate > 0.0 && m_survey.noise_std.cols() > 0 &&
               m_survey.noise_std(Eigen::all, m_survey.surveyed).maxCoeff() > 0.0;
    }

    [[nodiscard]] bool is_too_many(int targets) const {
        return targets > most_outliers * static_cast<double>(m_survey.surveyed.size());
    }

    [[nodiscard]] double first_inflation() const {
        const Points misfit = (m_survey.form - m_net.nodes()).cwiseQuotient(m_noise);
        return misfit(Eigen::all, m_survey.surveyed).cwiseAbs().maxCoeff() /
               largest_misfit_at_first;
    }

    /// What is known of the targets in use, with the noise so many times larger.
    [[nodiscard]] Knowledge knowledge(double inflation) const {
        Knowledge known = knowledge_of(m_net, m_survey, m_noise, m_test.left_out(), m_law.std());
        known.weights /= inflation * inflation;
        return known;
    }

    /// Fits lengths and form, and inverts there.
    GaussNewtonResult fit(const Knowledge& known, const Guess& start, std::vector<bool> slack,
                          double inflation) {
        GaussNewtonResult result =
            fit_to_survey(m_net, m_statics, known, m_law, start, std::move(slack),
                          inflation * m_tolerance, m_settings.max_iterations);
        m_statics.invert();
        return result;
    }

    /// Fits, and again with other targets left out until the test has no more to say.
    /// @param slack edges (m) to begin with
    GaussNewtonResult fit_and_test(const Guess& start, std::vector<bool> slack, double inflation) {
        m_test.reopen();
        GaussNewtonResult fitted = fit(knowledge(inflation), start, std::move(slack), inflation);
        for (int revision = 0; is_testing() && fitted.converged && revision < most_revisions;
             ++revision) {
            m_test.evaluate(m_statics, fitted.guess.form, inflation);
            if (!m_test.revise() || is_too_many(m_test.left_out_count())) {
                break;
            }
            const Knowledge known = knowledge(inflation);
            fitted = fit(known, fitted.guess, where_measured(m_net, known, m_statics.slack()),
                         inflation);
        }
        return fitted;
    }

    /// The same, with the edges to begin with that the survey tells to be slack.
    GaussNewtonResult fit_and_test(const Guess& start, double inflation) {
        return fit_and_test(start, slack_by_survey(m_net, knowledge(inflation), m_law), inflation);
    }

    /// As if the noise were large, then less and less; and from the nominal net as soon as this has
    /// shown which targets led astray there.
    GaussNewtonResult from_coarse_to_fine(const Guess& nominal) {
        m_test.take_all_back();
        Guess settled = nominal;
        std::vector<bool> slack(m_net.edge_count(), false);
        const auto refine = [&](double inflation) {
            GaussNewtonResult fitted = fit_and_test(settled, inflation);
            if (!fitted.converged) {
                const Knowledge known = knowledge(inflation);
                fitted = fit_and_test(settled, where_measured(m_net, known, slack), inflation);
            }
            if (fitted.converged) {
                settled = fitted.guess;
                slack = m_statics.slack();
            }
            return fitted;
        };
        for (double inflation = first_inflation(); inflation > 1.0; inflation *= smaller) {
            const int left_out = m_test.left_out_count();
            refine(inflation);
            if (m_test.left_out_count() > left_out) {
                GaussNewtonResult direct = fit_and_test(nominal, 1.0);
                if (direct.converged && !is_too_many(m_test.left_out_count())) {
                    return direct;
                }
            }
        }
        return refine(1.0);
    }

    const CableNet& m_net;
    const Survey& m_survey;
    const LengthLaw& m_law;
    MaximumAPosterioriSettings m_settings;
    Points m_noise;
    double m_tolerance;
    ConditionedStatics m_statics;
    GrossErrorTest m_test;
};

}  // namespace

Identification identify_by_maximum_a_posteriori(const CableNet& net, const Survey& survey,
                                                const LengthLaw& law,
                                                const MaximumAPosterioriSettings& settings) {
    check(settings);
    check_survey(net, survey);
    if (is_exact_and_complete(net, survey)) {
        Identification result = identify_by_exact_balance(net, survey, law);
        result.method = "map";
        return result;
    }
    return Search(net, survey, law, settings).run();
}

}  // namespace taut
