// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/elimination_order.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A net renumbered for the solvers: free nodes first, in the order in which their rows are
/// eliminated, supports behind them.
struct LocalNet {
    int free_count = 0;
    std::vector<int> node_of;         ///< local index -> node of the net
    std::vector<Edge> edges;          ///< in local indices, order of the net's edges
    Eigen::VectorXd axial_stiffness;  ///< m [N]
    std::vector<TensionLaw> laws;     ///< of the net
    std::vector<int> law_of_edge;     ///< m indices of laws, -1: linear; none where all are
    Eigen::VectorXd loads;            ///< 3 free_count [N]
    /// Subtracted from all coordinates: the middle of the supports, where the net lies so far from
    /// zero (a national grid) that its coordinates' rounding errors would be felt; else zero [m].
    Eigen::Vector3d origin;
    Eigen::Matrix3Xd nodes;  ///< 3 x n, nominal coordinates less origin, brought near [m]
    /// No node of the net's form is farther from the origin of the supports: what is, as a nominal
    /// place or a start, is brought that near, so that rounding errors are of the net's own size.
    double reach = 0.0;
    Eigen::Vector3d middle;  ///< of the supports, less origin [m]
    Points supports;         ///< 3 x n_B, the net's own coordinates of the supports [m]

    /// Null: linear.
    [[nodiscard]] const TensionLaw* law(size_t edge) const {
        return law_of_edge.empty() || law_of_edge[edge] < 0 ? nullptr : &laws[law_of_edge[edge]];
    }

    /// Coordinates of all nodes from the net's numbering to this one, brought near; supports from
    /// the net.
    void gather(const Eigen::Ref<const Points>& form, Eigen::Matrix3Xd& local) const;
    /// The way back.
    [[nodiscard]] Points scatter(const Eigen::Matrix3Xd& local) const;
};

/// Free nodes in their own order: the numbering of r_I.
[[nodiscard]] LocalNet number_naturally(const CableNet& net);

/// Free nodes in an order that keeps the Cholesky factor of the stiffness sparse.
[[nodiscard]] LocalNet number_for_elimination(const CableNet& net,
                                              Ordering ordering = Ordering::quick);

}  // namespace taut
