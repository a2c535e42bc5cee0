// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/boundary_snooping.hpp"
#include "estimation/data_snooping.hpp"
#include "estimation/gauss_newton.hpp"
#include "estimation/length_snooping.hpp"
#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"

namespace taut {

struct SurveyFitSettings {
    int max_iterations = 50;                             ///< Gauss-Newton steps of each fit
    double false_alarm_rate = default_false_alarm_rate;  ///< of data snooping; 0: none
    /// Standard deviation of the normal prior of the lengths, in those of the prior. 1: maximum a
    /// posteriori; much more: all but the maximum of the likelihood.
    double prior_width = 1.0;
    Progress progress = {};  ///< asked before each step whether to go on; nothing is told
};

/// Fits form and lengths to a survey under the statics: the maximum a posteriori estimate (map) of
/// docs/theory.md, with its slack set, gross errors rejected by data snooping, and the covariance
/// linearised at the result. Three loops, from the inside: Gauss-Newton steps at one slack set
/// (gauss_newton()), the slack set that the fitted form shows, the targets that are rejected. A
/// survey for which these do not settle is fitted with rounded tension laws (feasible_descent()),
/// from wide corners to narrow ones, and where that does not do by continuation over the noise.
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
    /// @return the result; not converged where lengths and form still moved
    /// @throws std::runtime_error where the statics are singular at what the search ended with
    /// @throws Interrupted where a stop was requested
    [[nodiscard]] GaussNewtonResult run();

    /// Of the result: twice the objective of (map), and for what was rejected as much as it takes
    /// to be rejected; infinite where nothing settles. To compare fits of one survey.
    [[nodiscard]] double cost() const { return m_cost; }
    /// Whether so many targets contradict the others that it is not they who are wrong.
    [[nodiscard]] bool contradicts_too_many() const { return m_contradicts_too_many; }
    [[nodiscard]] const DataSnooping& snooping() const { return m_snooping; }
    [[nodiscard]] const LengthSnooping& length_snooping() const { return m_length_snooping; }
    [[nodiscard]] const BoundarySnooping& boundary_snooping() const { return m_boundary_snooping; }
    /// What was told, with the priors that the fit was made with: those of edges beyond theirs are
    /// wide; and what was released of the boundary.
    [[nodiscard]] const PriorKnowledge& knowledge() const { return m_knowledge; }
    /// Linearised and inverted at the result.
    [[nodiscard]] const LinearisedStatics& statics() const { return m_statics; }
    /// To go on from there, with other observations.
    [[nodiscard]] LinearisedStatics& statics() { return m_statics; }
    /// A step this small changes nothing that the survey could show [m].
    [[nodiscard]] double tolerance() const { return m_tolerance; }
    /// The targets and readings in use and the prior.
    [[nodiscard]] Observations observations() const { return observations(1.0); }

private:
    [[nodiscard]] Observations observations(double inflation) const;
    [[nodiscard]] Iterate nominal() const;
    [[nodiscard]] std::vector<bool> as_seen(std::vector<bool> slack) const;
    [[nodiscard]] std::vector<bool> shown_slack(const Iterate& iterate) const;
    [[nodiscard]] std::vector<bool> measured_slack(double inflation) const;
    void follow_tension_laws(GaussNewtonResult& fitted, const Observations& observed, double inflation);
    void evaluate(const GaussNewtonResult& fitted, double inflation);
    [[nodiscard]] GaussNewtonResult fit(const Iterate& start, std::vector<bool> slack,
                                        double inflation);
    [[nodiscard]] GaussNewtonResult fit_rounded(const Iterate& start, double inflation);
    [[nodiscard]] GaussNewtonResult fit_and_snoop(const Iterate& start, std::vector<bool> slack,
                                                  double inflation);
    [[nodiscard]] GaussNewtonResult fit_and_snoop(const Iterate& start, double inflation);
    [[nodiscard]] GaussNewtonResult by_rounded_tension_laws();
    [[nodiscard]] GaussNewtonResult from_coarse_to_fine();
    template <class Fit>
    [[nodiscard]] GaussNewtonResult without_slack_set(Fit fit) {
        m_is_rounded = true;
        GaussNewtonResult fitted = fit();
        m_is_rounded = false;
        return fitted;
    }
    [[nodiscard]] bool revise();
    /// What was left out and released at a fit, and what it costs.
    struct Explanation {
        double cost = 0.0;  ///< infinite where it did not settle
        DataSnooping::Rejected rejected;
        std::vector<LengthSuspect> lengths;
        BoundaryReleases boundary;
        Iterate iterate;
        std::vector<bool> slack;
        Eigen::VectorXd target_statistics;  ///< n
    };
    [[nodiscard]] Explanation explanation_of(const GaussNewtonResult& fitted) const;
    void take_over(const Explanation& explanation);
    [[nodiscard]] GaussNewtonResult fit_as(const Explanation& explanation);
    [[nodiscard]] std::vector<int> suspect_nodes() const;
    void try_clamps(GaussNewtonResult& fitted);
    void readmit_all();
    [[nodiscard]] Eigen::VectorXd blamed() const;
    [[nodiscard]] double cost_of(const GaussNewtonResult& fitted) const;
    void try_boundary(GaussNewtonResult& fitted);
    void take_over_releases();
    [[nodiscard]] Iterate with_released(Iterate iterate) const;
    [[nodiscard]] bool is_sound(const GaussNewtonResult& fitted) const {
        return fitted.converged && !m_snooping.rejects_too_many();
    }
    [[nodiscard]] double widest_corner() const;
    [[nodiscard]] double first_inflation() const;

    const CableNet& m_net;
    Survey m_survey;  ///< with its supports, where they tell something
    PriorKnowledge m_knowledge;
    double m_length_std;  ///< of the priors, together [m]
    SurveyFitSettings m_settings;
    Points m_noise;
    double m_tolerance;
    LinearisedStatics m_statics;
    DataSnooping m_snooping;
    LengthSnooping m_length_snooping;
    BoundarySnooping m_boundary_snooping;
    double m_cost = 0.0;
    bool m_contradicts_too_many = false;
    enum class BoundaryTest { none, at_once, one_by_one };
    BoundaryTest m_boundary_test = BoundaryTest::none;
    bool m_is_rounded = false;    ///< (rounded-law) takes the place of the slack set
    double m_corner_width = 0.0;  ///< where the rounded fits have got to [m]
};

}  // namespace taut
