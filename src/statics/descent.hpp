// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "statics/net_state.hpp"
#include "statics/stiffness_matrix.hpp"

namespace taut {

/// How a descent ended.
struct DescentResult {
    bool balanced = false;  ///< forces balance within the tolerance (see NetState::imbalance)
    int steps = 0;
};

/// Newton's method on the energy of a net, with a line search, and a diagonal shift where slack
/// edges make the stiffness singular. Does the symbolic work on construction; run() allocates
/// nothing.
class Descent {
public:
    explicit Descent(const LocalNet& net);

    /// Where the next run starts, and where the last one ended.
    [[nodiscard]] NetState& state() { return m_state; }

    /// Steps until forces balance, or `max_steps` are taken. Goes on below the tolerance until
    /// rounding errors stop it or a hundredth is reached.
    /// @param energy_decreases takes one entry a step [J]
    DescentResult run(const LocalNet& net, double relative_tolerance, int max_steps,
                      std::vector<double>& energy_decreases);

    /// Whether slack edges leave nodes loose: the stiffness is singular to rounding.
    [[nodiscard]] bool has_loose_nodes(const LocalNet& net);

private:
    [[nodiscard]] bool find_direction(const LocalNet& net, double& shift);

    NetState m_state;
    NetState m_trial;  ///< at the form that the line search looks at
    StiffnessMatrix m_matrix;
    StiffnessFactor m_factor;
    Eigen::VectorXd m_residual;
    Eigen::VectorXd m_direction;
};

}  // namespace taut
