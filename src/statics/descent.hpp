// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "statics/net_state.hpp"
#include "statics/stiffness_factor.hpp"

namespace taut {

/// How a descent ended.
struct DescentResult {
    bool balanced = false;  ///< forces balance within the tolerance (see NetState::imbalance)
    int steps = 0;
};

/// Limits at which a descent ends before the forces balance.
struct DescentLimits {
    int max_steps;
    /// Consecutive steps that the line search cuts below a twentieth. They show that a few edges
    /// go slack or taut in each step.
    int max_short_steps = std::numeric_limits<int>::max();
};

/// Newton's method on the energy of a net, with a line search, and a diagonal shift if slack edges
/// make the stiffness singular or struts make it indefinite. With struts no node moves farther in a
/// step than a quarter of the mean edge. While it converges fast, steps reuse the last factor.
/// run() does not allocate, except for a large net.
class Descent {
public:
    explicit Descent(const LocalNet& net);

    /// Largest move of a node in a step; infinite without struts [m].
    [[nodiscard]] double reach() const { return m_reach; }

    /// Steps until the forces balance or a limit is reached. Continues below the tolerance until
    /// rounding errors stop it or a hundredth of it is reached.
    /// @param energy_decreases receives one entry a step [J]
    DescentResult run(const LocalNet& net, Stiffness& stiffness, NetState& state,
                      double relative_tolerance, DescentLimits limits,
                      std::vector<double>& energy_decreases);

private:
    [[nodiscard]] bool find_direction(const LocalNet& net, Stiffness& stiffness,
                                      const NetState& state, double& shift);

    [[nodiscard]] bool solve(const Stiffness& stiffness, const NetState& state);

    NetState m_trial;  ///< at the form that the line search tries
    Eigen::VectorXd m_direction;
    double m_reach;  ///< largest move of a node in a step [m]
};

/// Whether struts give way: the stiffness of a net in equilibrium has a negative eigenvalue.
[[nodiscard]] bool is_unstable(const LocalNet& net, Stiffness& stiffness, const NetState& state);

/// A direction in which the energy falls away from an unstable equilibrium: near the eigenvector of
/// the most negative stiffness (3 n_I), the largest move of a node 1.
[[nodiscard]] Eigen::VectorXd direction_of_collapse(const LocalNet& net, Stiffness& stiffness,
                                                    const NetState& state);

/// Whether slack edges leave nodes of a net in equilibrium loose: its stiffness is singular up to
/// rounding errors.
[[nodiscard]] bool is_mechanism(const LocalNet& net, Stiffness& stiffness, const NetState& state);

}  // namespace taut
