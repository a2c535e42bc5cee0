// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/hypotheses.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/progress.hpp"

namespace taut {

struct SurveyFitSettings {
    int max_iterations = 50;                             ///< Gauss-Newton steps of each fit
    double false_alarm_rate = default_false_alarm_rate;  ///< of data snooping; 0: none
    /// Factor on the standard deviations of the priors of the lengths. 1: maximum a posteriori;
    /// much more: nearly maximum likelihood.
    double prior_width = 1.0;
    Progress progress = {};  ///< asked before each step whether to stop; gets no reports
};

/// Fits form and lengths to a survey under the statics: the maximum a posteriori estimate (map) of
/// docs/theory.md, with its slack set, gross errors rejected by data snooping, and the covariance
/// linearised at the result. Three loops, from the inside: Gauss-Newton steps at one slack set
/// (gauss_newton()), the slack set that the fitted form shows, the targets that are rejected. Where
/// these do not converge, the fit uses rounded tension laws (feasible_descent()), from wide corners
/// to narrow ones, and finally a continuation over the noise.
class SurveyFit {
public:
    /// Keeps a reference to the net. Not copied: its parts refer to each other.
    /// @throws std::invalid_argument for settings out of range, and as check_forces()
    /// @throws SurveyError as check_survey()
    SurveyFit(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
              const SurveyFitSettings& settings = {});
    SurveyFit(const SurveyFit&) = delete;
    SurveyFit& operator=(const SurveyFit&) = delete;

    /// Once. After it, the parts below are those of the result.
    /// @throws std::runtime_error where the statics are singular at what the search ended with
    /// @throws Interrupted where a stop was requested
    [[nodiscard]] LinearisedFit run();

    /// Whether lengths and form no longer moved.
    [[nodiscard]] bool converged() const { return m_converged; }

    /// Twice the objective of (map) at the result, plus the threshold of each rejected or released
    /// item; infinite where nothing converged. Compares fits of one survey.
    [[nodiscard]] double cost() const { return m_cost; }
    /// Whether more targets contradict the others than can have gross errors.
    [[nodiscard]] bool contradicts_too_many() const { return m_contradicts_too_many; }
    /// With their tests at the result.
    [[nodiscard]] const Hypotheses& hypotheses() const { return m_hypotheses; }
    /// Those found of each kind, the largest statistic first.
    [[nodiscard]] std::vector<Outlier> outliers() const;
    [[nodiscard]] std::vector<ForceOutlier> force_outliers() const;
    [[nodiscard]] std::vector<LengthOutlier> length_outliers() const;
    /// DetectableErrors::length, for these edges.
    [[nodiscard]] double detectable_length(const std::vector<int>& edges) const;
    /// The knowledge given, with the priors of released edges widened.
    [[nodiscard]] const PriorKnowledge& knowledge() const { return m_knowledge; }
    /// A step this small changes nothing that the survey could show [m].
    [[nodiscard]] double tolerance() const { return m_tolerance; }
    /// The targets and force measurements in use and the prior.
    [[nodiscard]] Observations observations() const { return observations(1.0); }

private:
    using BoundaryTest = Hypotheses::BoundaryTest;
    /// How a fit is made, and what is tested after it.
    struct Mode {
        double inflation = 1.0;   ///< (continuation): factor on the noise
        bool is_rounded = false;  ///< (rounded-law) replaces the slack set; only targets are tested
        BoundaryTest boundary = BoundaryTest::none;
    };
    /// What a search ended with.
    struct Fitted {
        Iterate iterate;
        bool converged = false;
    };
    /// A fit, with what it leaves out and releases.
    struct Explanation {
        Hypotheses hypotheses;
        Fitted fitted;
        std::vector<bool> slack;  ///< m
        double cost = 0.0;        ///< cost(); infinite where it is none

        [[nodiscard]] bool is_sound() const {
            return fitted.converged && !hypotheses.has_too_many(Hypotheses::Family::targets);
        }
    };
    void assume(const Hypotheses& hypotheses);
    [[nodiscard]] Observations observations(double inflation) const;
    [[nodiscard]] Iterate nominal() const;
    [[nodiscard]] std::vector<bool> as_seen(std::vector<bool> slack) const;
    [[nodiscard]] std::vector<bool> shown_slack(const Iterate& iterate) const;
    [[nodiscard]] std::vector<bool> measured_slack(double inflation) const;
    [[nodiscard]] Fitted search(const Iterate& start, const Observations& observed,
                                double inflation);
    void follow_tension_laws(Fitted& fitted, const Observations& observed, double inflation);
    [[nodiscard]] Fitted fit_with_slack_set(const Iterate& start, std::vector<bool> slack,
                                            double inflation);
    [[nodiscard]] Fitted fit_rounded(const Iterate& start, double inflation);
    [[nodiscard]] Explanation fit(Hypotheses hypotheses, const Iterate& start,
                                  std::vector<bool> slack, const Mode& mode);
    void test(Explanation& found, const Mode& mode) const;
    [[nodiscard]] Explanation explain(Hypotheses hypotheses, const Iterate& start, const Mode& mode,
                                      std::optional<std::vector<bool>> slack = {});
    [[nodiscard]] Explanation by_rounded_tension_laws(Hypotheses hypotheses);
    [[nodiscard]] Explanation from_coarse_to_fine(Hypotheses hypotheses, bool is_rounded);
    [[nodiscard]] Explanation with_boundary(Explanation found);
    [[nodiscard]] Explanation with_pair(Explanation other, int pair, bool is_target);
    [[nodiscard]] std::optional<Explanation> instead_of(const Explanation& best, int pair);
    [[nodiscard]] Explanation with_clamps(Explanation found);
    [[nodiscard]] std::vector<int> improbably_slack(const Explanation& found) const;
    [[nodiscard]] std::optional<Explanation> with_taut_edge(Explanation other, int edge,
                                                            const Mode& mode);
    [[nodiscard]] Explanation with_taut_edges(Explanation found);
    [[nodiscard]] Iterate with_released(Iterate iterate) const;
    [[nodiscard]] double widest_corner() const;
    [[nodiscard]] double first_inflation() const;

    const CableNet& m_net;
    Survey m_survey;                    ///< with the surveyed supports as targets
    std::vector<LengthPrior> m_priors;  ///< as given (m_I)
    // As assumed by the last fit.
    PriorKnowledge m_knowledge;
    std::vector<bool> m_rejected;         ///< targets, by node (n)
    std::vector<bool> m_rejected_forces;  ///< by force measurement
    double m_length_std;                  ///< of the priors, together [m]
    SurveyFitSettings m_settings;
    Points m_noise;
    double m_tolerance;
    StaticsModel m_model;
    // Of the last fit: where it has a factor, and where it converged or was rounded.
    std::optional<Linearisation> m_linearisation;
    Covariance m_covariance;
    Hypotheses m_hypotheses;
    double m_cost = 0.0;
    bool m_converged = false;
    bool m_contradicts_too_many = false;
    double m_corner_width = 0.0;  ///< that the rounded fits have reached [m]
};

}  // namespace taut
