// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What other surveys of the same net tell of x: its length deviations (m_I) and, behind them, the
/// common uncertain that are told, in their standard deviations. Their log-likelihood is
/// -1/2 x' J x + p' x; J is positive semidefinite. docs/theory.md, (epoch-evidence).
struct LengthEvidence {
    Eigen::MatrixXd information;  ///< J
    Eigen::MatrixXd root;         ///< R, R R' = J
    Eigen::VectorXd pull;         ///< p
};

/// What is known of form, lengths and all else apart from the statics: independent normal
/// distributions. docs/theory.md, (observation), (prior), (uncertain-parameters), (force-measurement).
struct Observations {
    Points form;  ///< 3 x n, as measured; anything where the weight is 0 [m]
    /// 3 x n, the diagonal of S, the inverse covariance of each measured place: 1 / variance of
    /// each coordinate where these are independent; 0 where nothing was measured [1/m2].
    Points weights;
    Points cross_weights;  ///< 3 x n, its entries xy, xz, yz; 3 x 0: all 0 [1/m2]
    /// 3 x n, prior mean of the places of supports from where the net has them, in the frame of the
    /// survey, and 1 / variance where they are unknown, else 0 [m, 1/m2].
    Points support_mean;
    Points support_weights;
    Eigen::VectorXd mean;  ///< m_I, prior mean of the length deviations [m]
    /// What these means may have in common: a root of its covariance (m_I x r), (length-trend);
    /// empty: nothing. For draws; a fit is made at the mean [m].
    Eigen::MatrixXd mean_root;
    /// Of the precision of all lengths, as a part of it: for a search that damps its steps.
    double length_damping = 0.0;
    Eigen::VectorXd variance;         ///< m_I, prior variance, positive [m2]
    Points load_mean;                 ///< 3 x n, of deviations of the nodes' loads [N]
    Points load_variance;             ///< 3 x n, of the same; 0: known [N2]
    Eigen::VectorXd common_mean;      ///< of each common unknown, in its standard deviations
    Eigen::VectorXd tension;          ///< m, as read; anything where the weight is 0 [N]
    Eigen::VectorXd tension_weights;  ///< m, 1 / variance, else 0 [1/N2]
    std::shared_ptr<const LengthEvidence> evidence;  ///< null: there is none
    Eigen::VectorXd evidence_pull;                   ///< p; empty without

    [[nodiscard]] Eigen::Matrix3d weight(int node) const;  ///< S of a node [1/m2]
    /// Makes S of a node so many times as large.
    void scale_weight(int node, double factor);
    /// S e of errors of places (3 x n) [1/m].
    [[nodiscard]] Points weighted(const Points& errors) const;
    /// e' S e of errors of places (3 x n).
    [[nodiscard]] double squared_norm(const Points& errors) const;
    void set_evidence(std::shared_ptr<const LengthEvidence> told);
};

/// A form, length deviations and values of all else that is unknown, which need not be in
/// equilibrium.
struct Iterate {
    Points form;                 ///< 3 x n, supports included [m]
    Eigen::VectorXd deviations;  ///< m_I [m]
    Points loads;                ///< 3 x n, deviations of the nodes' loads [N]
    Eigen::VectorXd common;      ///< the common uncertain, each divided by its standard deviation

    /// What evidence tells of: the deviations, and as many common uncertain as that leaves.
    [[nodiscard]] Eigen::VectorXd lengths_and_common(Eigen::Index size) const;

    /// Itself and a part of a step.
    [[nodiscard]] Iterate moved(const Iterate& step, double part = 1.0) const;
};

/// The nominal form, and no deviation of anything.
[[nodiscard]] Iterate nominal_iterate(const CableNet& net, int common_parameters = 0);

/// Standard deviation of each coordinate (3 x n), no smaller than a ten millionth of the net's mean
/// edge length, which stands for that of an exact one: far above rounding errors, far below any
/// instrument's, and no harder on the factorisation than it bears [m].
[[nodiscard]] Points with_noise_floor(const CableNet& net, const Survey& survey);

/// No target and no reading, length deviations of mean zero and one standard deviation, and all
/// else known.
[[nodiscard]] Observations nothing_observed(const CableNet& net, double length_std,
                                            int common_parameters = 0);

/// A survey without the targets that are rejected (one flag a node), and length deviations of mean
/// zero and one standard deviation. All else is known, and no force is read.
[[nodiscard]] Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                                   const std::vector<bool>& rejected, double length_std,
                                   int common_parameters = 0);

}  // namespace taut
