// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/observations.hpp"
#include "estimation/saddle_point_factor.hpp"
#include "statics/local_net.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// How tension laws are seen by strains that are known with standard deviations: corners and flat
/// parts are then smooth, and what their tangents miss counts as a length that nobody knows.
/// docs/theory.md (blurred-law). Empty where all edges are linear, or the laws are seen as they
/// are.
struct LawBlur {
    Eigen::VectorXd strain_stds;  ///< m [-]
    Eigen::VectorXd missed;       ///< m_I, variance of that length [m2]

    /// Whether no standard deviation differs by more than a tenth.
    [[nodiscard]] bool agrees_with(const LawBlur& other) const;
};

/// At first, before anything is found: by a standard deviation of all extensions [m].
[[nodiscard]] LawBlur blur_by(const CableNet& net, double extension_std);

/// The normal equations of observations under linearised statics, docs/theory.md (statics) and
/// (normal): with h the out-of-balance forces at an iterate, H = dh/dr, B = dh/dl_0, S and P the
/// inverse variances of what is observed and of the prior,
///
///   S dr + H lambda  = S (r_measured - r)
///   P dd + B' lambda = P (d_mean - d)
///   H dr + B dd      = -h
///
/// and the inverse of their matrix holds the posterior covariances of r and d (covariance). H
/// lambda and B' lambda at the lambda of the linearisation stand on the right side: what is left
/// there is then as small as the change that is solved for, and so are the rounding errors.
///
/// Here edges carry pressure as well as tension, so that all of it is smooth; edges of the slack
/// set carry neither. What a shown pressure means is settled afterwards, for each edge by itself.
class LinearisedStatics {
public:
    explicit LinearisedStatics(const CableNet& net);
    LinearisedStatics(const LinearisedStatics&) = delete;  // the factor refers to the local net
    LinearisedStatics& operator=(const LinearisedStatics&) = delete;

    /// The slack set: edges (m) that carry nothing.
    void set_slack(std::vector<bool> slack) { m_slack = std::move(slack); }
    [[nodiscard]] const std::vector<bool>& slack() const { return m_slack; }

    /// How tension laws are seen; sharp at first.
    void set_blur(LawBlur blur) { m_blur = std::move(blur); }
    [[nodiscard]] const LawBlur& blur() const { return m_blur; }
    /// After invert() at the same iterate: the blur by the standard deviations that were found, no
    /// less than half of what it was.
    [[nodiscard]] LawBlur blur_found(const Iterate& iterate) const;

    /// With a width [m] above 0 no edge carries pressure: with e = l - l_0 its tension is
    ///
    ///   T = EA/l_0 (e + sqrt(e^2 + 4 w^2)) / 2,
    ///
    /// a smooth law that differs from a cable's by less than EA/l_0 w. docs/theory.md (rounded-law)
    void round_corners(double width) { m_corner_width = width; }

    /// Linearises at an iterate, and factorises.
    /// @return false where no factor is found
    [[nodiscard]] bool linearise(const Iterate& iterate, const Observations& observations);

    /// After linearise(), at the same iterate: the change to the conditional mean. At another
    /// iterate: with its misfit and forces, but the matrix as linearised.
    [[nodiscard]] Iterate step(const Iterate& iterate, const Observations& observations) const;

    /// Finds the covariances below, after linearise().
    void invert() { m_covariance = m_matrix.covariance(); }
    [[nodiscard]] Eigen::VectorXd length_variances() const;         ///< m_I [m2]
    [[nodiscard]] Eigen::VectorXd extension_variances() const;      ///< of l - l_0, m_I [m2]
    [[nodiscard]] Eigen::Matrix3d form_covariance(int node) const;  ///< of a free node [m2]

private:
    /// What an edge does at an iterate.
    struct EdgeRates {
        Eigen::Vector3d force;        ///< h of its first node, -h of its second [N]
        Eigen::Matrix3d stiffness;    ///< k = d force / d r of its first node [N/m]
        Eigen::Vector3d length_rate;  ///< b = d force / d l_0 [N/m]
    };
    [[nodiscard]] EdgeRates rates(int edge, const Iterate& iterate) const;
    [[nodiscard]] Eigen::VectorXd prior_variances(const Observations& observations) const {
        return m_blur.missed.size() > 0 ? observations.variance + m_blur.missed
                                        : observations.variance;
    }
    [[nodiscard]] double length_variance(int edge, const Iterate& iterate) const;
    void set_weights(const Observations& observations);
    void add_edge(int edge, const Iterate& iterate);
    [[nodiscard]] SaddlePointFactor::Vector right_side(const Iterate& iterate,
                                                       const Observations& observations) const;
    void set_reactions(const Eigen::Matrix3Xd& multipliers);

    const CableNet& m_net;
    LocalNet m_local;
    std::vector<int> m_local_of;     ///< node of the net -> local index
    std::vector<int> m_interior_of;  ///< edge -> place among the interior edges, or -1
    std::vector<int> m_free_nodes;   ///< in the order of elimination
    std::vector<bool> m_slack;
    LawBlur m_blur;
    double m_corner_width = 0.0;
    SaddlePointFactor m_matrix;
    SaddlePointFactor::Covariance m_covariance;
    Eigen::Matrix3Xd m_place_reactions;  ///< H lambda as linearised, 3 x free nodes
    Eigen::VectorXd m_length_reactions;  ///< B' lambda as linearised, one an edge

    // Units that make all blocks of order 1: of places and lengths, and of multipliers.
    double m_length_unit = 1.0;
    double m_multiplier_unit = 1.0;
};

}  // namespace taut
