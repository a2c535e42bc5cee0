// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Evidence of other surveys of the same net on x: the length deviations (m_I), then the given
/// common parameters in their standard deviations. The log-likelihood is -1/2 x' J x + p' x, with J
/// positive semidefinite. docs/theory.md, (epoch-evidence).
struct LengthEvidence {
    Eigen::MatrixXd information;  ///< J
    Eigen::MatrixXd root;         ///< R, R R' = J
    Eigen::VectorXd pull;         ///< p
};

/// All observations and priors of a fit: independent normal distributions. docs/theory.md,
/// (observation), (prior), (uncertain-parameters), (force-measurement).
struct Observations {
    Points form;  ///< 3 x n, as measured; anything where the weight is 0 [m]
    /// 3 x n, the diagonal of S, the inverse covariance of each measured place: 1 / variance of
    /// each coordinate where these are independent; 0 where nothing was measured [1/m2].
    Points weights;
    Points cross_weights;  ///< 3 x n, its entries xy, xz, yz; 3 x 0: all 0 [1/m2]
    /// 3 x n, prior mean of the supports' deviations from their places in the net, in the frame of
    /// the survey [m].
    Points support_mean;
    Points support_weights;  ///< 3 x n, 1 / variance of that where uncertain, else 0 [1/m2]
    Eigen::VectorXd mean;    ///< m_I, prior mean of the length deviations [m]
    /// Root of the prior covariance of what these means have in common (m_I x r), (length-trend);
    /// empty: nothing. Used by draws only: a fit is made at the mean [m].
    Eigen::MatrixXd mean_root;
    /// What a fit shows of that to first order: mean (r) and root of the covariance (r x r) of the
    /// numbers that mean_root multiplies.
    Eigen::VectorXd shown_mean;
    Eigen::MatrixXd shown_root;
    /// Added to the precision of all lengths, as a part of it: damps the steps of a search.
    double length_damping = 0.0;
    Eigen::VectorXd variance;  ///< m_I, prior variance, positive [m2]
    Points load_mean;          ///< 3 x n, of deviations of the nodes' loads [N]
    /// 3 x n, the diagonal of V, the covariance of each node's; 0: known [N2].
    Points load_variance;
    Points cross_load_variance;       ///< 3 x n, its entries xy, xz, yz; 3 x 0: all 0 [N2]
    Eigen::VectorXd common_mean;      ///< of each common parameter, in its standard deviations
    Eigen::VectorXd tension;          ///< m, as measured; anything where the weight is 0 [N]
    Eigen::VectorXd tension_weights;  ///< m, 1 / variance, else 0 [1/N2]
    /// m x common parameters: how far each of these moves a force measurement from the tension,
    /// (shared-error) [N].
    Eigen::MatrixXd tension_bias;
    std::shared_ptr<const LengthEvidence> evidence;  ///< null: there is none
    Eigen::VectorXd evidence_pull;                   ///< p; empty without

    [[nodiscard]] Eigen::Matrix3d weight(int node) const;           ///< S of a node [1/m2]
    [[nodiscard]] Eigen::Matrix3d load_covariance(int node) const;  ///< V of a node [N2]
    /// Multiplies S of a node.
    void scale_weight(int node, double factor);
    /// Multiplies the standard deviations of a measured place along x, y and z.
    void scale_stds(int node, const Eigen::Array3d& factors);
    /// S e of errors of places (3 x n) [1/m].
    [[nodiscard]] Points weighted(const Points& errors) const;
    /// e' S e of errors of places (3 x n).
    [[nodiscard]] double squared_norm(const Points& errors) const;
    /// The tensions that would have been measured (m) [N].
    [[nodiscard]] Eigen::VectorXd measured(const Eigen::VectorXd& tensions,
                                           const Eigen::VectorXd& common) const {
        return tensions + tension_bias * common;
    }
    void set_evidence(std::shared_ptr<const LengthEvidence> of_others);
};

/// A form, length deviations and values of all uncertain parameters, not necessarily in
/// equilibrium.
struct Iterate {
    Points form;                 ///< 3 x n, supports included [m]
    Eigen::VectorXd deviations;  ///< m_I [m]
    Points loads;                ///< 3 x n, deviations of the nodes' loads [N]
    Eigen::VectorXd common;      ///< common parameters, each divided by its standard deviation

    /// The x of LengthEvidence: the deviations, then the first common parameters up to this size.
    [[nodiscard]] Eigen::VectorXd lengths_and_common(Eigen::Index size) const;

    /// This plus a part of a step.
    [[nodiscard]] Iterate moved(const Iterate& step, double part = 1.0) const;
};

/// The nominal form, with all deviations 0.
[[nodiscard]] Iterate nominal_iterate(const CableNet& net, int common_parameters = 0);

/// Standard deviation of each coordinate (3 x n), at least a ten millionth of the net's mean edge
/// length, which stands for an exact one. That is far above rounding errors, far below any
/// instrument's noise, and large enough for the factorisation [m].
[[nodiscard]] Points with_noise_floor(const CableNet& net, const Survey& survey);

/// No target and no force measurement; length deviations with mean zero and this standard
/// deviation; all else exact.
[[nodiscard]] Observations nothing_observed(const CableNet& net, double length_std,
                                            int common_parameters = 0);

/// A survey without rejected targets (one flag a node); all else as in nothing_observed().
[[nodiscard]] Observations observe(const CableNet& net, const Survey& survey, const Points& noise,
                                   const std::vector<bool>& rejected, double length_std,
                                   int common_parameters = 0);

}  // namespace taut
