// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/prior_check.hpp"

#include <cmath>

#include "estimation/prior_likelihood.hpp"

namespace taut {
namespace {

/// Gain of log likelihood that chance does not explain; and from which on the prior is untenable.
constexpr double significant_gain = 8.0;
constexpr double untenable_gain = 20.0;

constexpr int fewest_lengths = 8;

}  // namespace

bool FoundScale::is_contradicted() const {
    return ratio > 0.0 && std_dev > 0.0 && std::abs(ratio - 1.0) > significant_std * std_dev;
}

bool PriorCheck::has_mean() const {
    return mean_std > 0.0 && std::abs(mean) > significant_std * mean_std;
}

bool PriorCheck::is_contradicted() const {
    return gain > significant_gain || has_mean() || outliers > 0;
}

bool PriorCheck::is_untenable() const {
    return gain > untenable_gain;
}

bool PriorCheck::is_too_wide() const {
    constexpr double narrower = 0.8;
    return likeliest.std_dev() < narrower * checked.std_dev();
}

PriorCheck check_prior_by_lengths(const LengthPrior& prior, const PriorLikelihood& likelihood) {
    PriorCheck result{.checked = prior, .lengths = likelihood.count(), .likeliest = prior};
    if (result.lengths < fewest_lengths) {
        return result;
    }
    const double of_checked = likelihood(prior);
    for (const LengthPrior::Kind kind :
         {LengthPrior::Kind::uniform, LengthPrior::Kind::normal, LengthPrior::Kind::bimodal}) {
        const LengthPrior found = likelihood.likeliest(kind);
        if (const double gain = likelihood(found) - of_checked; gain > result.gain) {
            result.gain = gain;
            result.likeliest = found;
        }
    }
    return result;
}

}  // namespace taut
