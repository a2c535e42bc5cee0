// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/saddle_point_factor.hpp"
#include "statics/local_net.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What is known of form and lengths, apart from the statics: independent normal distributions.
struct Knowledge {
    Points form;               ///< 3 x n, as measured; anything where the weight is 0 [m]
    Points weights;            ///< 3 x n, 1 / variance of each measured coordinate, else 0 [1/m2]
    Eigen::VectorXd mean;      ///< m_I, of the length deviations [m]
    Eigen::VectorXd variance;  ///< m_I, likewise, positive [m2]
};

/// A form and lengths that need not be in equilibrium.
struct Guess {
    Points form;                 ///< 3 x n [m]
    Eigen::VectorXd deviations;  ///< m_I length deviations [m]
};

/// What is known, conditioned on the linearised statics: mean and covariance of form r and length
/// deviations d under h + H dr + B dd = 0, with h the out-of-balance forces at a guess, H = dh/dr
/// and B = dh/dl_0. With S and P the inverse variances of what is known, the conditions of
/// optimality are
///
///   S dr + H lambda  = S (r_measured - r)
///   P dd + B' lambda = P (d_mean - d)
///   H dr + B dd      = -h
///
/// and the inverse of their matrix holds the covariances of r and d. H lambda and B' lambda at the
/// lambda of the linearisation stand on the right side: what is left there is then as small as the
/// change that is solved for, and so are the rounding errors.
///
/// Here edges carry pressure as well as tension, so that all of it is smooth; edges that are named
/// slack carry neither. What a shown pressure means is settled afterwards, for each edge by itself.
class ConditionedStatics {
public:
    explicit ConditionedStatics(const CableNet& net);
    ~ConditionedStatics() = default;
    // The matrix refers to the local net.
    ConditionedStatics(const ConditionedStatics&) = delete;
    ConditionedStatics& operator=(const ConditionedStatics&) = delete;
    ConditionedStatics(ConditionedStatics&&) = delete;
    ConditionedStatics& operator=(ConditionedStatics&&) = delete;

    /// Edges (m) that carry nothing.
    void set_slack(std::vector<bool> slack) { m_slack = std::move(slack); }
    [[nodiscard]] const std::vector<bool>& slack() const { return m_slack; }

    /// Linearises at a guess, and factorises.
    /// @return false where no factor is found
    [[nodiscard]] bool linearise(const Guess& guess, const Knowledge& knowledge);

    /// After linearise(), at the same guess: the change to the conditional mean. At another guess:
    /// with its misfit and forces, but the matrix as linearised.
    [[nodiscard]] Guess step(const Guess& guess, const Knowledge& knowledge) const;

    /// Finds the covariances below, after linearise().
    void invert() { m_covariance = m_matrix.covariance(); }
    [[nodiscard]] Eigen::VectorXd length_variances() const;         ///< m_I [m2]
    [[nodiscard]] Eigen::VectorXd extension_variances() const;      ///< of l - l_0, m_I [m2]
    [[nodiscard]] Eigen::Matrix3d form_covariance(int node) const;  ///< of a free node [m2]

private:
    /// What an edge does at a guess.
    struct EdgeRates {
        Eigen::Vector3d force;        ///< h of its first node, -h of its second [N]
        Eigen::Matrix3d stiffness;    ///< k = d force / d r of its first node [N/m]
        Eigen::Vector3d length_rate;  ///< b = d force / d l_0 [N/m]
    };
    [[nodiscard]] EdgeRates rates(int edge, const Guess& guess) const;
    void set_weights(const Knowledge& knowledge);
    void add_edge(int edge, const Guess& guess);
    [[nodiscard]] SaddlePointFactor::Vector right_side(const Guess& guess,
                                                       const Knowledge& knowledge) const;
    void set_reactions(const Eigen::Matrix3Xd& multipliers);

    const CableNet& m_net;
    LocalNet m_local;
    std::vector<int> m_local_of;     ///< node of the net -> local index
    std::vector<int> m_interior_of;  ///< edge -> place among the interior edges, or -1
    std::vector<int> m_free_nodes;   ///< in the order of elimination
    std::vector<bool> m_slack;
    SaddlePointFactor m_matrix;
    SaddlePointFactor::Covariance m_covariance;
    Eigen::Matrix3Xd m_place_reactions;  ///< H lambda as linearised, 3 x free nodes
    Eigen::VectorXd m_length_reactions;  ///< B' lambda as linearised, one an edge

    // Units that make all blocks of order 1: of places and lengths, and of multipliers.
    double m_length_unit = 1.0;
    double m_multiplier_unit = 1.0;
};

}  // namespace taut
