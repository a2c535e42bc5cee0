// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "statics/net_state.hpp"
#include "statics/path_law.hpp"
#include "statics/stiffness_factor.hpp"

namespace taut {

/// A primal-dual interior-point method for eq. SOCP. There an edge either is slack or stretches:
///
///   T >= 0,   s = l_0 + e - l(r) >= 0,   T s = 0,   and the forces T balance the loads,
///
/// with the elongation e of the edge's law at T: T l_0/EA if it is linear, else the sum over the
/// straight parts of the law (PathPart).
/// The method follows the path T s = mu of all edges and of their parts towards mu = 0 by predictor
/// and corrector (S. Mehrotra, On the implementation of a primal-dual interior point method, SIAM
/// J. Optim. 2 (1992) 575-601). The corrector includes the curvature of l(r) in s. Each step solves
/// with the stiffness of the net, in which an edge has stiffness T / (s + T de/dT) along it and T /
/// l across. The number of edges that go slack or pass a corner of their law hardly affects the
/// number of steps, while Newton's method on the energy needs a step for every few of them. The
/// result is as near to the equilibrium as mu is to zero.
class InteriorPoint {
public:
    explicit InteriorPoint(const LocalNet& net);

    /// Moves the state near its equilibrium in at most `max_steps` steps, of one factorisation
    /// each. Does not allocate. Does nothing if the ends of an edge coincide: it has no direction.
    /// @return steps taken
    int run(const LocalNet& net, Stiffness& stiffness, NetState& state, int max_steps);

private:
    struct PathEdge {
        double tension;              ///< T > 0 [N]
        double elongation;           ///< e [m]
        double play;                 ///< s > 0 [m]
        double wanted;               ///< change of T s that the direction aims at [N m]
        double tension_rate;         ///< dT along the direction [N]
        double elongation_rate;      ///< de along the direction [m]
        Eigen::Vector3d difference;  ///< of the direction at source and target [m]
    };

    [[nodiscard]] std::span<PathPart> parts_of(size_t edge);
    [[nodiscard]] std::span<const PathPart> parts_of(size_t edge) const;
    void start_on_path(const LocalNet& net, const NetState& state, double mu);
    void update_imbalance(const LocalNet& net, const NetState& state);
    [[nodiscard]] bool arrived(const LocalNet& net, const NetState& state) const;
    [[nodiscard]] bool factorize(const LocalNet& net, Stiffness& stiffness, const NetState& state);
    void aim_at(double mu);
    void correct(const NetState& state);
    void find_direction(const LocalNet& net, const Stiffness& stiffness, const NetState& state);
    [[nodiscard]] double longest_step(const NetState& state) const;
    [[nodiscard]] double mean_product_after(double step, const NetState& state) const;
    void move(double step, const LocalNet& net, NetState& state);

    std::vector<PathEdge> m_edges;
    std::vector<PathPart> m_parts;      ///< of all edges' laws
    std::vector<size_t> m_parts_begin;  ///< of each edge, and their end
    std::vector<EdgeState> m_springs;   ///< edges as the stiffness takes them
    Eigen::VectorXd m_imbalance;        ///< 3 n_I [N]
    Eigen::VectorXd m_direction;        ///< 3 n_I [m]
};

}  // namespace taut
