// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/chain_target.hpp"
#include "numerics/random_numbers.hpp"

namespace taut {

/// Somewhere about as far from the centre as the posterior is wide, or farther, so that chains that
/// agree have seen it. Nothing where there is no equilibrium at the centre.
[[nodiscard]] std::optional<ChainState> start_of_chain(ChainTarget& target, RandomNumbers& random);

/// One trajectory of (hamiltonian), taken or not, by the leapfrog (R. M. Neal, MCMC using
/// Hamiltonian dynamics, 2011).
/// @return its probability of being taken by its energy
double follow_trajectory(ChainTarget& target, ChainState& state, double step, int steps,
                         RandomNumbers& random);

/// Draws the lengths of slack edges anew, which hardly moves the form: trajectories would take long
/// to cross what the prior leaves them. By Metropolis' rule (W. K. Hastings 1970) for lengths of
/// the prior beyond what the edges span.
void renew_slack_lengths(ChainTarget& target, ChainState& state, RandomNumbers& random);

}  // namespace taut
