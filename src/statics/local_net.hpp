// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/elimination_order.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// An elastic support: a force K (r - r_0) on a free node.
struct Spring {
    int node;                   ///< local index
    Eigen::Matrix3d stiffness;  ///< K [N/m]
    Eigen::Vector3d place;      ///< r_0, less the origin [m]
};

/// What two elastic supports on one frame pass on to each other.
struct SpringPair {
    int first;                  ///< local index
    int second;                 ///< a later one
    Eigen::Matrix3d stiffness;  ///< force on the first by a shift of the second [N/m]
    int edge;                   ///< that joins them, too; -1: none
};

/// A net renumbered for the solvers: free nodes first, in the order in which their rows are
/// eliminated, supports behind them.
struct LocalNet {
    int free_count = 0;
    std::vector<int> node_of;         ///< local index -> node of the net
    std::vector<Edge> edges;          ///< in local indices, order of the net's edges
    Eigen::VectorXd axial_stiffness;  ///< m [N]
    std::vector<TensionLaw> laws;     ///< of the net, those of cables that sag among them
    std::vector<int> law_of_edge;     ///< m indices of laws, -1: linear; empty if all are
    bool sags = false;                ///< whether a cable does
    std::vector<bool> struts;         ///< m; empty if there are none
    Eigen::VectorXd loads;            ///< 3 free_count [N]
    std::vector<Spring> springs;      ///< of elastic supports
    std::vector<SpringPair> spring_pairs;
    /// Subtracted from all coordinates. The middle of the supports if the net lies so far from zero
    /// (as in a national grid) that rounding errors of its coordinates would matter; else zero [m].
    Eigen::Vector3d origin;
    Eigen::Matrix3Xd nodes;  ///< 3 x n, nominal coordinates less origin, within reach [m]
    /// No node of a form can be farther from the middle of the supports. Nominal nodes and starts
    /// beyond it are moved to this distance, so that rounding errors are relative to the net's
    /// size.
    double reach = 0.0;
    Eigen::Vector3d middle;  ///< of the supports, less origin [m]
    Points supports;         ///< 3 x n_B, the net's own coordinates of the supports [m]

    /// Forces on the springs, added to those of the free nodes (3 free_count) [N].
    /// @param form as nodes
    void add_spring_forces(const Eigen::Matrix3Xd& form, Eigen::VectorXd& forces) const {
        for (const auto& [node, stiffness, place] : springs) {
            forces.segment<3>(Eigen::Index{3} * node) += stiffness * (form.col(node) - place);
        }
        if (!spring_pairs.empty()) {
            add_pair_forces(spring_shifts(form).reshaped(), forces);
        }
    }
    /// Of springs from their places; 0 at other free nodes (3 x free_count) [m].
    /// @param form as nodes
    [[nodiscard]] Eigen::Matrix3Xd spring_shifts(const Eigen::Matrix3Xd& form) const {
        Eigen::Matrix3Xd shifts = Eigen::Matrix3Xd::Zero(3, free_count);
        for (const Spring& spring : springs) {
            shifts.col(spring.node) = form.col(spring.node) - spring.place;
        }
        return shifts;
    }
    /// Forces that pairs of springs pass on (3 free_count) [N].
    /// @param shifts of all free nodes (3 free_count) [m]
    void add_pair_forces(const Eigen::VectorXd& shifts, Eigen::VectorXd& forces) const {
        for (const SpringPair& pair : spring_pairs) {
            const Eigen::Index a = Eigen::Index{3} * pair.first;
            const Eigen::Index b = Eigen::Index{3} * pair.second;
            forces.segment<3>(a) += pair.stiffness * shifts.segment<3>(b);
            forces.segment<3>(b) += pair.stiffness.transpose() * shifts.segment<3>(a);
        }
    }

    /// Null if the edge is linear.
    [[nodiscard]] const TensionLaw* law(size_t edge) const {
        return law_of_edge.empty() || law_of_edge[edge] < 0 ? nullptr : &laws[law_of_edge[edge]];
    }

    /// Whether the energy is convex: all edges are cables.
    [[nodiscard]] bool is_convex() const { return struts.empty(); }
    [[nodiscard]] bool is_strut(size_t edge) const { return !struts.empty() && struts[edge]; }

    /// Copies coordinates from the net's numbering to this one, moved within reach; supports from
    /// the net.
    void gather(const Eigen::Ref<const Points>& form, Eigen::Matrix3Xd& local) const;
    /// The reverse of gather().
    [[nodiscard]] Points scatter(const Eigen::Matrix3Xd& local) const;
};

/// Free nodes in their own order: the numbering of r_I.
[[nodiscard]] LocalNet number_naturally(const CableNet& net);

/// Free nodes in an order that keeps the Cholesky factor of the stiffness sparse.
[[nodiscard]] LocalNet number_for_elimination(const CableNet& net,
                                              Ordering ordering = Ordering::quick);

}  // namespace taut
