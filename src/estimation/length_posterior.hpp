// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <utility>

#include "taut/estimation/edge_status.hpp"
#include "taut/export/core.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Likelihood of one length deviation x by a survey, whatever the prior. While the edge is taut it
/// has the shape of a normal density. Where it is slack, any x beyond slack_from is equally likely,
/// as likely as the survey finds the edge without tension: with z the extension of the edge in
/// standard deviations and phi, Phi the standard normal density and distribution,
///
///     taut:  Phi(z) N(x; mean, std^2)       slack: phi(z) / std   for x > slack_from
///
/// docs/theory.md, (slack-mixture).
struct LengthLikelihood {
    double mean = 0.0;                                         ///< [m]
    double std_dev = std::numeric_limits<double>::infinity();  ///< [m]; infinite: not known
    /// Length of the edge in the surveyed form less nominal unstressed length [m].
    double slack_from = std::numeric_limits<double>::infinity();
    double slack_from_std = std::numeric_limits<double>::infinity();  ///< where surely slack [m]
    /// z, negative for pressure; infinite: surely taut. -infinite: surely slack.
    double extension = std::numeric_limits<double>::infinity();
    /// No x outside these is possible: of an exact form where the tension law is flat [m].
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();  ///< upper bound, likewise [m]
};

/// Takes a normal prior out of a normal posterior: 1/std^2 = 1/posterior_std^2 - 1/prior_std^2.
/// Where the posterior is no narrower, nothing is left. Standard deviations must be positive, which
/// is not checked.
[[nodiscard]] TAUT_CORE_EXPORT LengthLikelihood without_prior(double prior_mean, double prior_std,
                                                              double posterior_mean,
                                                              double posterior_std);

/// A distribution of one length deviation.
struct LengthPosterior {
    double mean = 0.0;               ///< [m]
    double std_dev = 0.0;            ///< [m]
    double lower = 0.0;              ///< 95 % interval [m]
    double upper = 0.0;              ///< its upper end [m]
    double slack_probability = 0.0;  ///< that the deviation exceeds slack_from
};

/// Likelihood times the density of the prior itself, normalised, docs/theory.md (posterior):
/// exactly, a mixture of truncated normal and uniform distributions. The interval holds 95 %, 2.5 %
/// on either side, or more where it has to reach to the mean; it never leaves the bounds of a
/// uniform prior. Where the edge is rather slack than not, all that is known is that bound: the
/// interval begins at slack_from or where it would anyway, if that is lower, and ends at the bound
/// of a uniform prior.
/// @param prior with a positive scale, not checked
/// @throws std::invalid_argument for a mean that is not finite, or a std that is not positive
[[nodiscard]] TAUT_CORE_EXPORT LengthPosterior posterior_of(const LengthPrior& prior,
                                                            const LengthLikelihood& likelihood);

/// Mean [m] and variance [m2] of the same distribution.
/// @throws std::invalid_argument as posterior_of()
[[nodiscard]] TAUT_CORE_EXPORT std::pair<double, double> moments_of(
    const LengthPrior& prior, const LengthLikelihood& likelihood);

/// What a posterior says of its edge: slack where that is more probable than not; else by its
/// standard deviation.
/// @param prior_std standard deviation of the length deviation before the survey [m]
[[nodiscard]] TAUT_CORE_EXPORT EdgeStatus status_of(double prior_std,
                                                    const LengthPosterior& posterior);

}  // namespace taut
