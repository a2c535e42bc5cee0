// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_posterior.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numerics/truncated_mixture.hpp"

namespace taut {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// log N(x; mean, std^2) but for a constant, the same for every std; 0 for an infinite one.
double log_normal_density(double x, double mean, double std_dev) {
    const double z = std_dev < infinity ? (x - mean) / std_dev : 0.0;
    return -0.5 * z * z - (std_dev < infinity ? std::log(std_dev) : 0.0);
}

/// Extension below which an edge is surely slack, in standard deviations; its square could
/// overflow.
constexpr double surely_slack = -1e6;

/// Adds prior part times likelihood: N(centre, spread^2) (uniform where the spread is infinite) on
/// [lower, upper].
void add_part(std::vector<TruncatedNormal>& parts, const LengthLikelihood& likelihood,
              double centre, double spread, double prior_lower, double prior_upper) {
    const double lower = std::max(prior_lower, likelihood.least);
    const double upper = std::min(prior_upper, likelihood.most);
    const double z = likelihood.extension < surely_slack ? -infinity : likelihood.extension;
    if (z > -infinity) {
        // A product of normal densities is one again.
        const double prior_precision = 1.0 / (spread * spread);
        const double precision = prior_precision + 1.0 / (likelihood.std_dev * likelihood.std_dev);
        double mean = centre;
        if (likelihood.std_dev < infinity) {
            mean = likelihood.mean + prior_precision / precision * (centre - likelihood.mean);
        }
        // log Phi(z), by its tail where that underflows.
        constexpr double far = -30.0;
        const double log_taut =
            z > far ? std::log(0.5 * std::erfc(-z / std::numbers::sqrt2))
                    : -0.5 * z * z - std::log(-z * std::sqrt(2.0 * std::numbers::pi));
        parts.push_back(
            {.log_height = log_normal_density(mean, centre, spread) +
                           log_normal_density(mean, likelihood.mean, likelihood.std_dev) + log_taut,
             .mean = mean,
             .std_dev = 1.0 / std::sqrt(precision),
             .lower = lower,
             .upper = upper});
    }
    constexpr double surely_taut = 10.0;  // slack with a probability below 1e-20
    if (z < surely_taut) {
        const bool is_sure = z == -infinity || likelihood.std_dev == infinity;
        parts.push_back(
            {.log_height = log_normal_density(centre, centre, spread) +
                           (is_sure ? 0.0 : -0.5 * z * z - std::log(likelihood.std_dev)),
             .mean = centre,
             .std_dev = spread,
             .lower = std::clamp(likelihood.slack_from, lower, upper),
             .upper = upper,
             .is_marked = true});
    }
}

double bound_of(const LengthPrior& prior) {
    return prior.kind == LengthPrior::Kind::uniform ? prior.scale : infinity;
}

/// (posterior)
TruncatedMixture mixture_of(const LengthPrior& prior, const LengthLikelihood& likelihood) {
    prior.check();
    if (!std::isfinite(likelihood.mean) || !(likelihood.std_dev > 0.0)) {
        throw std::invalid_argument(
            fmt::format("the likelihood has mean {} and std {}, expected a finite and a positive "
                        "number",
                        likelihood.mean, likelihood.std_dev));
    }
    const double bound = bound_of(prior);
    if (likelihood.extension < surely_slack && !(likelihood.slack_from < bound)) {
        // Slack, but impossible under the prior: the prior alone.
        LengthLikelihood none;
        none.extension = infinity;
        return mixture_of(prior, none);
    }
    std::vector<TruncatedNormal> parts;
    switch (prior.kind) {
        case LengthPrior::Kind::uniform:
            add_part(parts, likelihood, 0.0, infinity, -bound, bound);
            break;
        case LengthPrior::Kind::normal:
            add_part(parts, likelihood, 0.0, prior.scale, -infinity, infinity);
            break;
        case LengthPrior::Kind::bimodal:
            for (const double mode : {-prior.scale, prior.scale}) {
                const double spread =
                    std::sqrt(prior.std_dev() * prior.std_dev() - prior.scale * prior.scale);
                add_part(parts, likelihood, mode, spread, -infinity, infinity);
            }
            break;
    }
    return TruncatedMixture(parts);
}

}  // namespace

LengthLikelihood without_prior(double prior_mean, double prior_std, double posterior_mean,
                               double posterior_std) {
    // Below this part of the prior's precision, what the survey adds is rounding error.
    constexpr double smallest_part = 1e-6;
    const double ratio = posterior_std / prior_std;
    const double part = 1.0 / (ratio * ratio) - 1.0;
    if (!(part > smallest_part)) {
        return {};
    }
    return {.mean = prior_mean + (posterior_mean - prior_mean) / (part * ratio * ratio),
            .std_dev = prior_std / std::sqrt(part)};
}

LengthPosterior posterior_of(const LengthPrior& prior, const LengthLikelihood& likelihood) {
    const TruncatedMixture mixture = mixture_of(prior, likelihood);
    const double bound = bound_of(prior);
    const auto [mean, variance] = mixture.moments();
    LengthPosterior posterior{.mean = mean,
                              .std_dev = std::sqrt(variance),
                              .lower = mixture.quantile(0.025),
                              .upper = mixture.quantile(0.975),
                              .slack_probability = mixture.marked()};
    if (posterior.slack_probability > 0.5) {
        posterior.lower = std::max(std::min(posterior.lower, likelihood.slack_from), -bound);
        posterior.upper = std::isfinite(bound) ? bound : posterior.upper;
    }
    // A slack part of little weight can move the mean out of the interval.
    posterior.lower = std::min(posterior.lower, posterior.mean);
    posterior.upper = std::max(posterior.upper, posterior.mean);
    return posterior;
}

std::pair<double, double> moments_of(const LengthPrior& prior, const LengthLikelihood& likelihood) {
    return mixture_of(prior, likelihood).moments();
}

EdgeStatus status_of(double prior_std, const LengthPosterior& posterior) {
    if (posterior.slack_probability > 0.5) {
        return EdgeStatus::slack;
    }
    return status_of(prior_std, posterior.std_dev);
}

}  // namespace taut
