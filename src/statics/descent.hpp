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

/// When a descent ends though forces do not balance yet.
struct DescentLimits {
    int max_steps;
    /// Steps in a row cut by the line search to less than a twentieth: then ever more edges go
    /// slack or taut, a few a step.
    int max_short_steps = std::numeric_limits<int>::max();
};

/// Newton's method on the energy of a net, with a line search, and a diagonal shift where slack
/// edges make the stiffness singular. Where it converges fast, the next steps are taken with the
/// same factor. run() allocates nothing, but for a large net.
class Descent {
public:
    explicit Descent(const LocalNet& net);

    /// Steps until forces balance, or a limit is reached. Goes on below the tolerance until
    /// rounding errors stop it or a hundredth is reached.
    /// @param energy_decreases takes one entry a step [J]
    DescentResult run(const LocalNet& net, Stiffness& stiffness, NetState& state,
                      double relative_tolerance, DescentLimits limits,
                      std::vector<double>& energy_decreases);

private:
    [[nodiscard]] bool find_direction(const LocalNet& net, Stiffness& stiffness,
                                      const NetState& state, double& shift);

    [[nodiscard]] bool solve(const Stiffness& stiffness, const NetState& state);

    NetState m_trial;  ///< at the form that the line search looks at
    Eigen::VectorXd m_direction;
};

/// Whether slack edges leave nodes of a net in equilibrium loose: its stiffness is singular to
/// rounding.
[[nodiscard]] bool is_mechanism(const LocalNet& net, Stiffness& stiffness, const NetState& state);

}  // namespace taut
