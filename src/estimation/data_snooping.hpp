// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/linearised_statics.hpp"
#include "taut/identification/identification.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The quantile that the largest of so many independent statistics, each chi-squared with three
/// degrees of freedom, exceeds with the probability `false_alarm_rate` (Sidak); infinite for 0.
[[nodiscard]] double outlier_threshold(double false_alarm_rate, size_t targets);

/// More targets with gross errors than this part: not they are wrong, but net, frame, law or noise.
inline constexpr double most_outliers = 0.25;

/// Which nodes lie next to each node.
using Neighbours = std::vector<std::vector<int>>;
[[nodiscard]] Neighbours neighbours_of(const CableNet& net);

/// Of the targets in use those whose statistic is above the threshold and the largest of all in use
/// that are two edges away or less: a gross error shows in the residuals around it, too.
/// @param statistics by node (n); @param left_out flags by node (n)
[[nodiscard]] std::vector<int> worst_targets(const std::vector<int>& surveyed,
                                             const Neighbours& neighbours,
                                             const Eigen::VectorXd& statistics,
                                             const std::vector<bool>& left_out, double threshold);

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
    /// Targets in use above the threshold, at the last evaluation.
    [[nodiscard]] int suspicious_count() const;

    /// Statistics (n) at an inverted fit; 0 at nodes that were not surveyed. Where the fit was made
    /// as if the noise were larger, by a factor, the scale of the residuals is not that noise, but
    /// what the median of the statistics tells; no smaller than the true noise.
    void evaluate(const ConditionedStatics& statics, const Points& fitted_form,
                  double inflation = 1.0);

    /// Leaves out the targets above the threshold, of neighbouring ones only the worst, since a
    /// gross error shows in the residuals around it, too. Where there are none, takes back for good
    /// those that fit what all others tell. To first order the statistic of a target is the same in
    /// use and left out; where it is not, that of the target left out is the one to trust: it does
    /// not hang on a small difference of Sigma and C.
    /// @return whether anything changed
    [[nodiscard]] bool revise();

    void leave_out_suspicious();
    /// Begins anew, with all targets in use.
    void take_all_back();
    /// Lets targets that were taken back be left out again.
    void reopen();

    [[nodiscard]] std::vector<Outlier> outliers() const;
    /// Root mean square of the standardised residuals in use, over their expectation.
    [[nodiscard]] double noise_ratio() const;

private:
    [[nodiscard]] bool is_left_out(int node) const { return m_left_out[node]; }
    [[nodiscard]] double median_statistic() const;

    const Survey& m_survey;
    const Points& m_noise;
    double m_threshold;
    Neighbours m_neighbours;
    std::vector<bool> m_left_out;
    std::vector<bool> m_acquitted;  ///< taken back for good
    Eigen::VectorXd m_statistics;
    Eigen::VectorXd m_distances;
    double m_squares = 0.0;
    double m_redundancy = 0.0;
};

}  // namespace taut
