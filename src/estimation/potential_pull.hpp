// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "estimation/form_of_model.hpp"
#include "estimation/observations.hpp"
#include "estimation/statics_model.hpp"

namespace taut {

/// - dU/dx of (hamiltonian) by its parts, the form eliminated by the statics; without the pull of
/// the priors of lengths and loads, which are the metric's own.
struct PotentialPull {
    Eigen::VectorXd lengths;  ///< of the unstressed lengths of all edges (m) [1/m]
    Eigen::VectorXd common;   ///< of the common parameters
    Points places;            ///< of the nodes, less the reactions of the edges (3 x n) [1/m]
    Points multipliers;       ///< lambda, of the balance: pulls of the loads (3 x n) [1/N]
};

/// @param form with the stiffness at the iterate
/// @param at in equilibrium
[[nodiscard]] PotentialPull potential_pull(const StaticsModel& model,
                                           const Observations& observations,
                                           const FormOfModel& form, const Iterate& at);

}  // namespace taut
