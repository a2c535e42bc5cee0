// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "statics/edge_state.hpp"
#include "statics/local_net.hpp"

namespace taut {

/// A net at one form: its edges' states and nodal forces. All memory is allocated on construction.
class NetState {
public:
    explicit NetState(const LocalNet& net);

    void set_unstressed_lengths(const LocalNet& net,
                                const Eigen::Ref<const Eigen::VectorXd>& lengths);
    [[nodiscard]] const Eigen::VectorXd& unstressed_lengths() const { return m_unstressed_lengths; }
    /// Coordinates of all nodes (3 x n); call update() after a change.
    [[nodiscard]] Eigen::Matrix3Xd& form() { return m_form; }
    [[nodiscard]] const Eigen::Matrix3Xd& form() const { return m_form; }
    void update(const LocalNet& net);

    [[nodiscard]] const std::vector<EdgeState>& edges() const { return m_edges; }
    /// h (3 n_I) [N].
    [[nodiscard]] const Eigen::VectorXd& forces() const { return m_forces; }
    /// Largest norm of the forces h_s over the free nodes [N].
    [[nodiscard]] double largest_force() const;
    [[nodiscard]] std::vector<int> slack_edges() const;
    /// Over the taut cables; mean_force() if there are none [N].
    [[nodiscard]] double mean_tension() const;
    /// Mean size of the forces in taut cables and struts; 0 if there are none [N].
    [[nodiscard]] double mean_force() const;
    /// Sum over the edges of 1/2 T (l - l_0): the elastic energy of linear edges [J].
    [[nodiscard]] double stretch_energy() const;
    /// Largest force h_s, in units of the force that counts as balanced at its node: the tolerance
    /// times mean_force() (the mean load if that is 0), plus the rounding error of
    /// the coordinates times the axial stiffness of the node.
    [[nodiscard]] double imbalance(const LocalNet& net, double relative_tolerance) const;

    /// V(this) - V(other), summed edge by edge to stay accurate if the two almost agree [J].
    [[nodiscard]] double energy_above(const NetState& other, const LocalNet& net) const;

private:
    Eigen::VectorXd m_unstressed_lengths;
    Eigen::Matrix3Xd m_form;
    std::vector<EdgeState> m_edges;
    Eigen::VectorXd m_forces;
    Eigen::VectorXd m_rounding;  ///< n_I, force by rounding errors of a coordinate of 1 m [N/m]
    struct Sum {
        double force = 0.0;
        int count = 0;
        void add(double of_one) {
            force += of_one;
            ++count;
        }
        [[nodiscard]] double mean() const { return count > 0 ? force / count : 0.0; }
    };
    Sum m_taut_cables;
    Sum m_all_forces;  ///< sizes, of cables and struts
};

}  // namespace taut
