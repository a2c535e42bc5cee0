// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/prior_likelihood.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Compares the prior of the fit with the likeliest uniform, normal or bimodal one, given the
/// estimates of the lengths without their prior, docs/theory.md (prior-check).
/// @return all except the common mean
[[nodiscard]] PriorCheck check_prior_by_lengths(const LengthPrior& prior,
                                                const PriorLikelihood& likelihood);

}  // namespace taut
