// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/hyperprior.hpp"
#include "identification/draw_posterior.hpp"
#include "taut/identification/identify.hpp"

namespace taut {

/// A prior for a fit, and the distribution over priors around it.
struct AssumedPrior {
    LengthPrior prior;
    std::optional<Hyperprior> around;  ///< empty: the prior is exact
    bool has_trend = false;            ///< Given::has_trend
    PosteriorSettings wanted;
};

/// What the options want of the posterior.
[[nodiscard]] PosteriorSettings wanted_by(const CableNet& net, const IdentifyOptions& options);

/// By a method under one prior. Where that is not map, a fit of its own shows noise, prior, length
/// outliers and frame (in parallel, since few surveys turn out to be off their frame).
[[nodiscard]] Identification identify_under_prior(IdentificationMethod method, const CableNet& net,
                                                  const Survey& survey, const AssumedPrior& prior,
                                                  const IdentifyOptions& options,
                                                  const Progress& progress);

}  // namespace taut
