// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "taut/adjustment/target_surface.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Which deviation of a form from its target is minimised.
enum class FormObjective {
    rms,      ///< the root of the mean square of the weighted deviations
    largest,  ///< the largest weighted deviation of a node
};

/// Weights of the squared deviation along the normal of the target and across it.
struct DeviationWeights {
    double normal = 1.0;      ///< 0 or more; of a node without normal in all directions
    double tangential = 0.1;  ///< across the normal, 0 or more
};

/// Weights of the squares of a node's deviations, in place of those of all nodes.
struct NodeWeights {
    int node = 0;             ///< index of a free node
    double normal = 0.0;      ///< of the deviation along the normal, 0 or more
    double tangential = 0.0;  ///< of the deviation across it, 0 or more
};

/// A target as it is given, before it is checked against a net: target_of().
struct GivenTarget {
    Points points;  ///< places of the nodes (3 x n), or vertices of a surface (3 x v) [m]
    std::vector<std::array<int, 3>> triangles = {};  ///< of a surface; empty: a form
    DeviationWeights weights = {};                   ///< of all nodes
    std::vector<NodeWeights> node_weights = {};      ///< of single nodes
    FormObjective objective = FormObjective::rms;    ///< what is minimised
};

/// Target place and normal of each free node. A node without normal (of a single cable, say) has
/// the weight `normal` in all directions. For plans only the ratios of weights count.
///
/// On a target surface a node may reach any point. Its normal n is that of the surface at the
/// nearest point c. Its place is where the line along n through its designed place q meets the
/// tangent plane at c. So it deviates by n . (r - c) along the normal, its distance from the
/// surface, and by (I - n n') (r - q) across it. Both move with the form: at().
///
/// Keeps no reference to the net, and shares the surface. What it gives by reference lives as long
/// as it does.
class TAUT_ADJUSTMENT_EXPORT FormTarget {
public:
    /// @param places 3 x n; those of supports are not read [m]
    /// @throws std::invalid_argument for wrong sizes, places that are not finite, and weights that
    ///   are negative or not finite
    FormTarget(const CableNet& net, Points places, DeviationWeights weights = {},
               FormObjective objective = FormObjective::rms);

    /// A surface; the designed places of the nodes say where along it each node belongs.
    /// @param surface shared with the target and all that at() gives
    /// @throws std::invalid_argument for no surface, weights as above, and where a free node is
    ///   further from the surface than 1 m or a quarter of the net's size, whichever is less (the
    ///   message names the unit in which the surface would fit), or beyond its border by more than
    ///   the mean length of an edge
    FormTarget(const CableNet& net, std::shared_ptr<const TargetSurface> surface,
               DeviationWeights weights = {}, FormObjective objective = FormObjective::rms);

    /// The target for a form (3 x n) [m]: on a surface the places and normals at the points nearest
    /// to the form, (surface-target); otherwise unchanged.
    /// @throws std::invalid_argument for a form of the wrong size, or not finite
    [[nodiscard]] FormTarget at(const Points& form) const;

    /// Sets weights of single nodes (n each); those of supports are not read.
    /// @throws std::invalid_argument as the constructor; the weights are then as before
    void set_weights(Eigen::VectorXd normal, Eigen::VectorXd tangential);
    /// The same of some nodes; all others keep theirs.
    void set_weights(const std::vector<NodeWeights>& of_nodes);

    /// Sets other places and keeps the normals.
    /// @throws std::invalid_argument for a wrong size, places that are not finite, and a surface
    void move_to(Points places);

    /// Weights of the squared deviations along the normal (n).
    [[nodiscard]] const Eigen::VectorXd& normal_weights() const { return m_normal_weight; }
    /// Weights of the squared deviations across it (n).
    [[nodiscard]] const Eigen::VectorXd& tangential_weights() const { return m_tangential_weight; }

    [[nodiscard]] FormObjective objective() const { return m_objective; }  ///< as given
    /// Null where the target is a form, not a surface.
    [[nodiscard]] const TargetSurface* surface() const { return m_surface.get(); }
    /// Where each node should stand (3 x n) [m].
    [[nodiscard]] const Points& places() const { return m_places; }
    /// Unit normals there (3 x n); 0 at supports and nodes without normal.
    [[nodiscard]] const Points& normals() const { return m_normals; }

    /// The weighted deviation of a node: W_s (r_s - p_s), with
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

    std::vector<int> m_free_nodes;  ///< but elastic supports: the frame is not adjusted
    std::shared_ptr<const TargetSurface> m_surface;
    Points m_designed;  ///< of a surface
    Points m_places;
    Points m_normals;
    Eigen::VectorXd m_normal_weight;
    Eigen::VectorXd m_tangential_weight;
    FormObjective m_objective;
};

/// The target of a net.
/// @throws std::invalid_argument as FormTarget and TargetSurface
/// @throws std::out_of_range for weights of a node that the net does not have
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT FormTarget target_of(const CableNet& net,
                                                          const GivenTarget& given);

/// What about a target surface may be wrong, one line each: triangles without area, nodes beyond
/// its border. None for a form.
/// @param target of this net, which is not checked
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<std::string> target_warnings(
    const CableNet& net, const FormTarget& target);

/// Deviation of a form from a target, over the free nodes; from a surface at the points nearest to
/// the form [m].
struct FormDeviation {
    double mean = 0.0;  ///< of the distances of the nodes
    double max = 0.0;   ///< the largest of these
    double rmse = 0.0;  ///< root of their mean square
    double normal_mean =
        0.0;  ///< of the absolute value along the normal, over the nodes that have one
    double normal_max = 0.0;   ///< the largest of these; 0 where no node has a normal
    double normal_rmse = 0.0;  ///< root of their mean square; 0 likewise
};

/// Deviation of a form from a target.
/// @param of a target of this net, which is not checked
/// @param form 3 x n [m]
/// @throws std::invalid_argument for a form of the wrong size, or not finite
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT FormDeviation deviation_from(const FormTarget& of,
                                                                  const CableNet& net,
                                                                  const Points& form);

}  // namespace taut
