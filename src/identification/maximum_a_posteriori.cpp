// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/maximum_a_posteriori.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "identification/exact_balance.hpp"
#include "identification/gross_errors.hpp"
#include "identification/outcome.hpp"
#include "identification/survey_fit.hpp"
#include "identification/survey_knowledge.hpp"

namespace taut {
namespace {

/// A step that moves nothing by more than this part of the smallest standard deviation of the
/// survey changes nothing that the survey could show.
constexpr double tolerance_in_noise = 1e-3;

constexpr int most_revisions = 100;

/// Where the search does not settle, it goes there in steps: as if the survey's noise were so many
/// times larger, each from where the one before ended. The less a survey binds the form, the
/// farther a linearisation holds.
constexpr std::array inflations{10.0, 3.0, 1.0};

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
        // An exact survey has no noise to measure errors by.
        const bool is_testing = m_settings.false_alarm_rate > 0.0 &&
                                m_survey.noise_std.cols() > 0 &&
                                m_survey.noise_std(Eigen::all, m_survey.surveyed).maxCoeff() > 0.0;
        if (is_testing) {
            screen();
        }
        Identification result{.method = "map"};
        GaussNewtonResult fitted = fit();
        for (int revision = 0; is_testing && revision < most_revisions; ++revision) {
            m_test.evaluate(m_statics, fitted.guess.form);
            if (!m_test.revise()) {
                break;
            }
            if (m_test.left_out_count() >
                most_outliers * static_cast<double>(m_survey.surveyed.size())) {
                result.status = IdentificationStatus::survey_does_not_fit;
                break;
            }
            fitted = fit();
        }
        if (result.status == IdentificationStatus::converged && !fitted.converged) {
            result.status = IdentificationStatus::iteration_limit;
        }
        m_test.evaluate(m_statics, fitted.guess.form);
        result.outliers = m_test.outliers();
        result.outlier_threshold = m_test.threshold();
        result.noise_ratio = m_test.noise_ratio();
        complete(result, m_net, m_survey, m_law,
                 likelihoods(m_net, m_statics, knowledge(), fitted.guess), fitted.guess.form);
        return result;
    }

private:
    [[nodiscard]] Knowledge knowledge() const {
        return knowledge_of(m_net, m_survey, m_noise, m_test.left_out(), m_law.std());
    }

    /// Gross errors that stand out before anything is identified: places that the law of the
    /// lengths does not let expect. Those would take the search astray.
    void screen() {
        Knowledge nothing = knowledge();
        nothing.weights.setZero();
        Guess nominal{.form = m_net.nodes(), .deviations = nothing.mean};
        m_statics.set_slack(slack_by_form(m_net, nominal, m_law));
        // One step takes the nodes to the equilibrium of the nominal lengths.
        if (!m_statics.linearise(nominal, nothing)) {
            return;
        }
        nominal.form += m_statics.step(nominal, nothing).form;
        m_statics.invert();
        m_test.screen(m_statics, nominal.form);
    }

    /// Fits lengths and form to the targets in use, and inverts there.
    GaussNewtonResult fit() {
        const auto fit_from = [this](Guess start, double inflation) {
            Knowledge known = knowledge();
            known.weights /= inflation * inflation;
            return fit_to_survey(m_net, m_statics, known, m_law, std::move(start),
                                 inflation * m_tolerance, m_settings.max_iterations);
        };
        const Guess nominal{.form = m_net.nodes(), .deviations = knowledge().mean};
        GaussNewtonResult result = fit_from(nominal, 1.0);
        if (!result.converged) {
            result.guess = nominal;
            for (const double inflation : inflations) {
                result = fit_from(std::move(result.guess), inflation);
            }
        }
        m_statics.invert();
        return result;
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
