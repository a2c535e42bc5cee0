// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "taut/adjustment/target_surface.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What of a form is to come near its target.
enum class FormObjective {
    rms,      ///< the root of the mean square of the weighted deviations
    largest,  ///< the largest weighted deviation of a node
};

/// Weights of the square of a deviation along the normal of the target and across it.
struct DeviationWeights {
    double normal = 1.0;  ///< along the normal, 0 or more; of a node without one in all directions
    double tangential = 0.1;  ///< across the normal, 0 or more
};

/// Where a net should stand: a place and a normal for each free node. A node without normal (the
/// nodes of a single cable, say) has the weight `normal` in all directions.
///
/// Of a surface a node may reach any point: its normal is that of the surface at the nearest point
/// c, and its place is where the line along that normal through its designed place q meets the
/// tangent plane there, so that it deviates by n . (r - c) along the normal, its distance from the
/// surface, and by (I - n n') (r - q) across it. Both move with the form: at().
///
/// Holds nothing of the net, and shares the surface. What it gives by reference lives as long as
/// it.
class TAUT_ADJUSTMENT_EXPORT FormTarget {
public:
    /// @param places 3 x n, supports included; these are not moved [m]
    /// @throws std::invalid_argument for wrong sizes, places that are not finite, and weights that
    ///   are negative, not finite or all zero
    FormTarget(const CableNet& net, Points places, DeviationWeights weights = {},
               FormObjective objective = FormObjective::rms);

    /// A surface; the nodes of the net tell where along it each node belongs.
    /// @param surface shared with the target and all that at() gives
    /// @throws std::invalid_argument for no surface, weights as above, and where a free node of the
    ///   net is further from the surface than 1 m or a quarter of the net's size, whichever is less
    ///   (the message says which unit of the surface would do, if one would), or further beyond its
    ///   border than the mean length of an edge
    FormTarget(const CableNet& net, std::shared_ptr<const TargetSurface> surface,
               DeviationWeights weights = {}, FormObjective objective = FormObjective::rms);

    /// The target as it is for a form (3 x n) [m]: of a surface the places and normals at the
    /// points that are nearest to the form, (surface-target); otherwise the same.
    /// @throws std::invalid_argument for a form of the wrong size, or not finite
    [[nodiscard]] FormTarget at(const Points& form) const;

    /// Weights of single nodes instead (n each); of supports they are not read.
    /// @throws std::invalid_argument as the constructor; where it is not for the size, the weights
    ///   are those refused, and others must be set
    void set_weights(Eigen::VectorXd normal, Eigen::VectorXd tangential);

    /// Other places, with the normals as they are.
    /// @throws std::invalid_argument for a wrong size, places that are not finite, and a surface
    void move_to(Points places);

    /// Of the square of each node's deviation along the normal (n).
    [[nodiscard]] const Eigen::VectorXd& normal_weights() const { return m_normal_weight; }
    /// Of the square of each node's deviation across it (n).
    [[nodiscard]] const Eigen::VectorXd& tangential_weights() const { return m_tangential_weight; }

    /// What of the deviations counts.
    [[nodiscard]] FormObjective objective() const { return m_objective; }
    /// Null where the target is a form.
    [[nodiscard]] const TargetSurface* surface() const { return m_surface.get(); }
    /// Where each node should stand (3 x n) [m].
    [[nodiscard]] const Points& places() const { return m_places; }
    /// Unit normals there (3 x n), 0 at supports and nodes without one.
    [[nodiscard]] const Points& normals() const { return m_normals; }

    /// The weighted deviation of a node that stands somewhere: W_s (r_s - p_s), with
    /// W_s = sqrt(w_n) n n' + sqrt(w_t) (I - n n') (weighted-deviation) [m].
    /// @param deviation r_s - p_s [m]
    /// @throws std::out_of_range for another node
    [[nodiscard]] Eigen::Vector3d weighted(int node, const Eigen::Vector3d& deviation) const;

    /// W_s of a node (3 x 3).
    /// @throws std::out_of_range for another node
    [[nodiscard]] Eigen::Matrix3d weight(int node) const;

private:
    void check_weights() const;
    void check_nearness(const CableNet& net) const;

    std::vector<int> m_free_nodes;
    std::shared_ptr<const TargetSurface> m_surface;
    Points m_designed;  ///< of a surface
    Points m_places;
    Points m_normals;
    Eigen::VectorXd m_normal_weight;
    Eigen::VectorXd m_tangential_weight;
    FormObjective m_objective;
};

/// How far a form is from a target, over the free nodes; of a surface from its points that are
/// nearest to the form [m].
struct FormDeviation {
    double mean = 0.0;         ///< of the distances of the nodes
    double max = 0.0;          ///< the largest of these
    double rmse = 0.0;         ///< root of their mean square
    double normal_mean = 0.0;  ///< of the size along the normal, over the nodes that have one
    double normal_max = 0.0;   ///< the largest of these; 0 where no node has a normal
    double normal_rmse = 0.0;  ///< root of their mean square; 0 likewise
};

/// How far a form is from a target.
/// @param of a target of this net, which is not checked
/// @param form 3 x n [m]
/// @throws std::invalid_argument for a form of the wrong size, or not finite
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT FormDeviation deviation_from(const FormTarget& of,
                                                                  const CableNet& net,
                                                                  const Points& form);

}  // namespace taut
