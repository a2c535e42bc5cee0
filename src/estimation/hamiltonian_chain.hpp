// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "estimation/linearisation.hpp"
#include "taut/progress.hpp"

namespace taut {

/// Samples of the posterior from several chains that know nothing of each other.
struct ChainSamples {
    std::vector<Iterate> iterates;  ///< in equilibrium under the model
    double step = 0.0;              ///< the least of a chain, in the units of (hamiltonian)
    double acceptance = 0.0;        ///< part of the trajectories that were taken
    /// By how much the chains differ: the largest of the mean tension's and the objective's R-hat,
    /// 1 where they agree (A. Gelman & D. B. Rubin 1992, of half chains).
    double disagreement = 0.0;
    static constexpr double agreed = 1.2;  ///< disagreement of chains that may be believed
};

/// Hamiltonian Monte Carlo on the posterior of all that is uncertain, with the form eliminated by
/// the exact statics of a model: docs/theory.md (hamiltonian). For posteriors that are far from
/// normal, as where edges are slack or taut within them. Costs thousands of equilibria.
/// @param model whose cables carry no pressure
/// @param observations with the prior that the samples are to have
/// @param taut edges that were seen to be taut: no sample has them slack
/// @param centre near equilibrium, with all cables taut: the trajectories have its metric
/// @return nothing where there is no factor, no equilibrium at the centre, or no way from there
/// @throws Interrupted
[[nodiscard]] std::optional<ChainSamples> hamiltonian_samples(
    const StaticsModel& model, const Observations& observations, std::span<const int> taut,
    const Iterate& centre, int count, std::uint64_t seed, const Progress& progress = {});

}  // namespace taut
