// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"

namespace taut {

/// How the x of one epoch (LengthEvidence) follows from that of another, each entry by itself:
///
///   x_to = factor x_from + e,   e of variance `added`
///
/// with the prior variances of both before any survey. docs/theory.md, (epoch-step).
struct EpochStep {
    Eigen::VectorXd factor;
    Eigen::VectorXd added;       ///< variances
    Eigen::VectorXd prior_from;  ///< variances
    Eigen::VectorXd prior_to;    ///< variances: factor^2 prior_from + added

    /// The step back.
    [[nodiscard]] EpochStep reversed() const;
};

/// The evidence of one survey alone on x, at its fit: the information that neither the prior nor
/// other surveys hold. docs/theory.md, (own-evidence).
/// @param common_count number of common parameters in x
[[nodiscard]] LengthEvidence own_evidence(const LinearisedFit& fitted,
                                          const Observations& observations, int common_count);

/// The evidence of no survey.
[[nodiscard]] LengthEvidence no_evidence(Eigen::Index size);

/// The evidence of two surveys of the same x.
[[nodiscard]] LengthEvidence sum_of(const LengthEvidence& a, const LengthEvidence& b);

/// The evidence on x_to that evidence on x_from amounts to, (epoch-step); with its root.
[[nodiscard]] LengthEvidence carried(const LengthEvidence& evidence, const EpochStep& step);

/// The evidence on the rest of x with these entries integrated out under a flat prior, (forgotten).
[[nodiscard]] LengthEvidence forgotten(LengthEvidence evidence,
                                       std::span<const Eigen::Index> entries);

/// How far x differs from the estimate of other surveys, as far as both show it.
struct Agreement {
    double squares = 0.0;  ///< chi-squared of `rank` degrees of freedom where nothing changed
    int rank = 0;

    /// Root mean square, about 1; 0 where nothing is shown.
    [[nodiscard]] double ratio() const;
    /// The ratio that chance exceeds once in a thousand times.
    [[nodiscard]] double limit() const;
};

/// Tests whether x of one survey is that of the others, docs/theory.md (epoch-change).
class EvidenceTest {
public:
    /// @param others carried to the epoch of the survey
    EvidenceTest(const Eigen::VectorXd& prior_variances, const LengthEvidence& others,
                 const LengthEvidence& own);

    /// Allows any change of an entry of x.
    void let_go(Eigen::Index entry);

    /// If only one entry of x changed besides those let go: its change, the standard deviation of
    /// that (infinite where the surveys do not show it), and their ratio.
    struct Changes {
        Eigen::VectorXd change;
        Eigen::VectorXd std_dev;
        Eigen::VectorXd statistic;
    };
    [[nodiscard]] Changes changes() const;

    /// If x changed by a multiple of a direction and by nothing else: that multiple and its
    /// standard deviation, infinite where the surveys do not show it.
    [[nodiscard]] std::pair<double, double> change_along(const Eigen::VectorXd& direction) const;

    [[nodiscard]] Agreement agreement() const;
    [[nodiscard]] Agreement agreement(std::span<const Eigen::Index> entries) const;

    /// Standard deviation of an additional independent change of each of these entries that
    /// explains their differences; 0 where these are no larger than expected.
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
