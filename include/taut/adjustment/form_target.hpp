// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// What of a form is to come near its target.
enum class FormObjective {
    rms,      ///< the root of the mean square of the weighted deviations
    largest,  ///< the largest weighted deviation of a node
};

/// Weights of the square of a deviation along the normal of the target and across it.
struct DeviationWeights {
    double normal = 1.0;
    double tangential = 0.1;
};

/// Where a net should stand: a place and a normal for each free node. A node without normal (the
/// nodes of a single cable, say) has the weight `normal` in all directions.
class FormTarget {
public:
    /// @param places 3 x n, supports included; these are not moved [m]
    /// @throws std::invalid_argument for wrong sizes, places that are not finite, and weights that
    ///   are negative, not finite or all zero
    FormTarget(const CableNet& net, Points places, DeviationWeights weights = {},
               FormObjective objective = FormObjective::rms);

    /// Weights of single nodes instead (n each); of supports they are not read.
    /// @throws std::invalid_argument as the constructor
    void set_weights(Eigen::VectorXd normal, Eigen::VectorXd tangential);

    /// Other places, with the normals as they are.
    /// @throws std::invalid_argument for a wrong size, and places that are not finite
    void move_to(Points places);

    [[nodiscard]] FormObjective objective() const { return m_objective; }
    [[nodiscard]] const Points& places() const { return m_places; }
    [[nodiscard]] const Points& normals() const { return m_normals; }

    /// The weighted deviation of a node that stands somewhere: W_s (r_s - p_s), with
    /// W_s = sqrt(w_n) n n' + sqrt(w_t) (I - n n') (weighted-deviation) [m].
    [[nodiscard]] Eigen::Vector3d weighted(int node, const Eigen::Vector3d& deviation) const;

    /// W_s of a node (3 x 3).
    [[nodiscard]] Eigen::Matrix3d weight(int node) const;

private:
    void check_weights() const;

    std::vector<int> m_free_nodes;
    Points m_places;
    Points m_normals;
    Eigen::VectorXd m_normal_weight;
    Eigen::VectorXd m_tangential_weight;
    FormObjective m_objective;
};

/// How far a form is from a target, over the free nodes [m].
struct FormDeviation {
    double mean = 0.0;
    double max = 0.0;
    double rmse = 0.0;
    double normal_mean = 0.0;  ///< of the size along the normal, over the nodes that have one
    double normal_max = 0.0;
    double normal_rmse = 0.0;
};

/// @param form 3 x n [m]
/// @throws std::invalid_argument for a form of the wrong size
[[nodiscard]] FormDeviation deviation_from(const FormTarget& target, const CableNet& net,
                                           const Points& form);

}  // namespace taut
