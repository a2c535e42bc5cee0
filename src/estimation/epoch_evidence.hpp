// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"

namespace taut {

/// How x, lengths and common uncertain, of one epoch follow from those of another, each by itself:
///
///   x_to = factor x_from + e,   e of variance `added`
///
/// with what was known of both before any survey. docs/theory.md, (epoch-step).
struct EpochStep {
    Eigen::VectorXd factor;
    Eigen::VectorXd added;       ///< variances
    Eigen::VectorXd prior_from;  ///< variances
    Eigen::VectorXd prior_to;    ///< variances: factor^2 prior_from + added

    /// The same the other way round.
    [[nodiscard]] EpochStep reversed() const;
};

/// What one survey tells of x by itself, at the fit of it: the information that the prior and other
/// surveys do not hold already. docs/theory.md, (own-evidence).
/// @param statics linearised and inverted at the fit
/// @param common_count so many of the first common uncertain are in x
[[nodiscard]] LengthEvidence own_evidence(const LinearisedStatics& statics,
                                          const Observations& observations, const Iterate& fitted,
                                          int common_count);

/// No survey: nothing.
[[nodiscard]] LengthEvidence no_evidence(Eigen::Index size);

/// What two surveys tell together; of x alike.
[[nodiscard]] LengthEvidence sum_of(const LengthEvidence& a, const LengthEvidence& b);

/// What evidence of x_from tells of x_to, (epoch-step); with its root.
[[nodiscard]] LengthEvidence carried(const LengthEvidence& evidence, const EpochStep& step);

/// What the rest of x is told where nothing is known of these entries but what else tells of them,
/// which may be anything: the evidence with them integrated out, (forgotten).
[[nodiscard]] LengthEvidence forgotten(LengthEvidence evidence,
                                       std::span<const Eigen::Index> entries);

/// How far x differs from what others let expect, as far as both show it.
struct Agreement {
    double squares = 0.0;  ///< chi-squared of `rank` degrees of freedom where nothing changed
    int rank = 0;

    /// Root mean square, about 1; 0 where nothing is shown.
    [[nodiscard]] double ratio() const;
    /// The ratio that chance exceeds once in a thousand times.
    [[nodiscard]] double limit() const;
};

/// A survey held against others: whether x is the same in all, docs/theory.md (epoch-change).
class EvidenceTest {
public:
    /// @param others as carried to the epoch of the survey
    EvidenceTest(const Eigen::VectorXd& prior_variances, const LengthEvidence& others,
                 const LengthEvidence& own);

    /// Lets an entry of x have changed by anything.
    void let_go(Eigen::Index entry);

    /// If nothing changed but for one entry of x besides those let go: that entry's change, its
    /// standard deviation (infinite where the surveys do not show it), and the change over it.
    struct Changes {
        Eigen::VectorXd change;
        Eigen::VectorXd std;
        Eigen::VectorXd statistic;
    };
    [[nodiscard]] Changes changes() const;

    /// If x changed by a multiple of a direction, and nothing else did: that multiple and its
    /// standard deviation, infinite where the surveys do not show it.
    [[nodiscard]] std::pair<double, double> change_along(const Eigen::VectorXd& direction) const;

    [[nodiscard]] Agreement agreement() const;
    [[nodiscard]] Agreement agreement(std::span<const Eigen::Index> entries) const;

    /// Standard deviation of one more change of each of these entries by itself, which explains how
    /// far they differ; 0 where they differ no further than is expected.
    [[nodiscard]] double spread(std::span<const Eigen::Index> entries) const;

private:
    void update();

    Eigen::VectorXd m_stds;        ///< before any survey
    Eigen::MatrixXd m_covariance;  ///< by the others, in these
    Eigen::VectorXd m_mean;
    Eigen::MatrixXd m_own;  ///< J
    Eigen::VectorXd m_pull;
    Eigen::VectorXd m_gradient;     ///< g
    Eigen::MatrixXd m_information;  ///< W
};

}  // namespace taut
