// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// What is wanted of the posterior besides lengths with their standard deviations.
struct PosteriorSettings {
    int count = 0;  ///< of draws
    std::uint64_t seed = 1;
    std::vector<int> covariance_of;  ///< IdentifyOptions::covariance_of
    bool by_chains = true;           ///< where all else fails, which takes long
};

/// Draws the posterior around a fit (draw_by_perturbation()), then sets tensions, places of missing
/// nodes and which edges are slack. From unreliable draws nothing is set but the reason.
/// docs/theory.md, (perturbed), (drawn).
/// @param result of the fit
/// @param fit_net of the fit, net_to_fit()
/// @param sites observations of the fit, with the prior as normal distributions
/// @throws Interrupted
void draw_posterior(Identification& result, const CableNet& net, const CableNet& fit_net,
                    const Survey& survey, const PriorKnowledge& knowledge,
                    const LinearisedFit& fitted, const Observations& sites,
                    const PosteriorSettings& settings, const Progress& progress);

/// Sets what follows from draws that a result has already: nothing where they are unreliable.
/// @param prior_std standard deviation of the prior of all lengths [m]
void set_summary_of_draws(Identification& result, const CableNet& net, const Survey& survey,
                          double prior_std);

}  // namespace taut
