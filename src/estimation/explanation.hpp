// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
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

/// A survey to explain, and all that is known besides. Keeps a reference to the net.
struct FitProblem {
    /// @throws std::invalid_argument for settings out of range, and as check_forces()
    /// @throws SurveyError as check_survey()
    FitProblem(const CableNet& of, const Survey& survey_of_it, const PriorKnowledge& known,
               const SurveyFitSettings& given);

    const CableNet& net;
    SurveyFitSettings settings;
    Survey survey;  ///< with the surveyed supports as targets
    PriorKnowledge knowledge;
    Points noise;           ///< standard deviations of the survey (3 x n) [m]
    double smallest_noise;  ///< of the targets [m]
    StaticsModel model;     ///< nothing released, all edges taut
    Hypotheses hypotheses;  ///< all in use

    /// A step this small changes nothing that the survey could show [m].
    [[nodiscard]] double tolerance() const { return 1e-3 * smallest_noise; }
    /// (rounded-law): the corner w of a net of mean stretch s at which slack edges carry the
    /// nominal tension with lengths one standard deviation too long: T = EA/l_0 w^2 / std for e =
    /// -std, so s = w^2 / std [m].
    [[nodiscard]] double widest_corner() const;
};

/// A problem with what hypotheses leave out and release.
struct Assumed {
    Assumed(const FitProblem& of, const Hypotheses& hypotheses);

    const FitProblem& problem;
    PriorKnowledge knowledge;           ///< with the priors of released edges widened
    std::vector<bool> rejected;         ///< targets, by node (n)
    std::vector<bool> rejected_forces;  ///< by force measurement
    StaticsModel model;

    /// The targets and force measurements in use and the prior.
    /// @param inflation (continuation): factor on the noise
    [[nodiscard]] Observations observations(double inflation = 1.0) const;
    /// Edges (m) assumed slack, corrected by what was seen.
    [[nodiscard]] std::vector<bool> as_seen(std::vector<bool> slack) const {
        return knowledge.as_seen(std::move(slack), rejected_forces);
    }
    /// Edges (m) that a form shows to be slack, (slack-form), and that were measured to be,
    /// (slack-survey).
    [[nodiscard]] std::vector<bool> shown_slack(const Iterate& iterate) const;
    [[nodiscard]] std::vector<bool> measured_slack(double inflation) const;
    /// An iterate with the common parameters now released, at 0, and the supports moved
    /// accordingly.
    [[nodiscard]] Iterate with_released(Iterate iterate) const;
};

/// How a fit is made, and what is tested after it.
struct FitMode {
    double inflation = 1.0;   ///< (continuation): factor on the noise
    bool is_rounded = false;  ///< (rounded-law) replaces the slack set; only targets are tested
    Hypotheses::BoundaryTest boundary = Hypotheses::BoundaryTest::none;
};

/// Where a fit begins, and what it ends with.
struct FitState {
    Iterate iterate;
    /// The slack set (m). Whether an edge is taut is a discrete question: a cable stretched by a
    /// hundredth of a millimetre when taut can sag by several when slack, and no small steps lead
    /// from one fit to the other.
    std::vector<bool> slack;
    LawBlur blur;               ///< (blurred-law)
    double corner_width = 0.0;  ///< (rounded-law), the widest to use or the last one used [m]
};

/// The nominal form of a problem; the slack set is to be chosen.
[[nodiscard]] FitState nominal_state(const FitProblem& problem);

/// A fit, with what it leaves out and releases: the maximum a posteriori estimate (map) of
/// docs/theory.md. A value; copies share the linearisation.
struct Explanation {
    Hypotheses hypotheses;  ///< with their tests, after test_hypotheses()
    FitState at;
    bool converged = false;  ///< lengths and form no longer moved
    /// Twice the objective of (map), plus the threshold of each rejected or released item;
    /// infinite where it is none. Compares fits of one survey.
    double cost = 0.0;
    std::shared_ptr<Linearisation> linearisation;  ///< there; null where there is no factor
    Covariance covariance;                         ///< of it; of a slack set where converged

    [[nodiscard]] bool is_sound() const {
        return converged && !hypotheses.has_too_many(Hypotheses::Family::targets);
    }
};

/// Fits once, with what these hypotheses leave out and release. Two loops: Gauss-Newton steps at
/// one slack set (gauss_newton()), and the slack set that the fitted form shows; or rounded tension
/// laws (feasible_descent()).
/// @param memory of a fit that is no longer needed
/// @throws Interrupted where a stop was requested
[[nodiscard]] Explanation fit(const FitProblem& problem, Hypotheses hypotheses, FitState start,
                              const FitMode& mode = {},
                              std::optional<Linearisation> memory = std::nullopt);

/// Tests all hypotheses at a fit: (snooping), (length-snooping), (slip), (boundary).
void test_hypotheses(const FitProblem& problem, Explanation& found, const FitMode& mode = {});

/// The third loop: fits, and repeats the fit until data snooping changes nothing more.
[[nodiscard]] Explanation explain(const FitProblem& problem, Hypotheses hypotheses, FitState start,
                                  const FitMode& mode = {});

/// The same from the nominal form, with those edges slack that were measured to be.
[[nodiscard]] Explanation explain_from_nominal(const FitProblem& problem, Hypotheses hypotheses,
                                               const FitMode& mode = {});

}  // namespace taut
