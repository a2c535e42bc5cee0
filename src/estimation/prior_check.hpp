// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/prior_likelihood.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Compares the prior that was told with the likeliest uniform, normal or bimodal one, by what a
/// survey tells of each length without its prior, docs/theory.md (prior-check).
/// @return all but the mean
[[nodiscard]] PriorCheck check_prior_by_lengths(const LengthPrior& prior,
                                                const PriorLikelihood& likelihood);

}  // namespace taut
