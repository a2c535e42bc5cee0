// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"

namespace taut {

/// The normal distributions (sites) that replace the prior of each length in the fit, and the fit
/// with them.
struct Propagated {
    Observations observations;  ///< mean and variance: the sites
    LinearisedFit fit;
};

/// Expectation propagation of the prior through the fit, docs/theory.md (tilted) and (site). The
/// site of each length becomes the one that gives mean and variance of likelihood times prior, for
/// all edges at once, until the means converge. The fit's means are then those of the posterior, as
/// far as normal distributions can represent it. A normal prior is its own site. Where this or the
/// fit does not converge, the result is the input.
/// @param observations with the prior that the fit was made with
/// @param tolerance of gauss_newton() [m]
[[nodiscard]] Propagated propagate_prior(const PriorKnowledge& knowledge, LinearisedFit fitted,
                                         const Observations& observations, double tolerance);

}  // namespace taut
