// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identification/conditioned_statics.hpp"
#include "taut/identification/identification.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Data snooping (Baarda) for targets, three coordinates at a time. For a target in use, the
/// residuals e at the fit have the covariance Q = Sigma - C, with the noise Sigma and the posterior
/// covariance C of the node's place; for one left out, Q = Sigma + C. Where there is no gross error
/// e' Q^-1 e has a chi-squared distribution of three degrees of freedom. The threshold is the
/// quantile that the largest of all stays below in all but a stated part of surveys, targets taken
/// as independent (Sidak).
class GrossErrorTest {
public:
    GrossErrorTest(const CableNet& net, const Survey& survey, const Points& noise,
                   double false_alarm_rate);

    [[nodiscard]] double threshold() const { return m_threshold; }
    [[nodiscard]] const std::vector<bool>& left_out() const { return m_left_out; }
    [[nodiscard]] int left_out_count() const;

    /// Statistics (n) at an inverted fit; 0 at nodes that were not surveyed.
    void evaluate(const ConditionedStatics& statics, const Points& fitted_form);

    /// Leaves out the targets above the threshold, of neighbouring ones only the worst, since a
    /// gross error shows in the residuals around it, too. Where there are none, takes back those
    /// that fit after all, each once at most.
    /// @return whether anything changed
    [[nodiscard]] bool revise();

    /// Leaves out, at the start, all targets far beyond the threshold from the places that are
    /// expected before the survey; statics inverted without any target.
    void screen(const ConditionedStatics& statics, const Points& expected_form);

    [[nodiscard]] std::vector<Outlier> outliers() const;
    /// Root mean square of the standardised residuals in use, over their expectation.
    [[nodiscard]] double noise_ratio() const;

private:
    [[nodiscard]] bool is_worst_around(int node) const;
    [[nodiscard]] bool is_left_out(int node) const { return m_left_out[static_cast<size_t>(node)]; }

    const Survey& m_survey;
    const Points& m_noise;
    double m_threshold;
    std::vector<std::vector<int>> m_neighbours;
    std::vector<bool> m_left_out;
    std::vector<bool> m_taken_back;
    Eigen::VectorXd m_statistics;
    Eigen::VectorXd m_distances;
    double m_squares = 0.0;
    double m_redundancy = 0.0;
};

}  // namespace taut
