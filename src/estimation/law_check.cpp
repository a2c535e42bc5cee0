// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/law_check.hpp"

#include <cmath>

#include "estimation/law_likelihood.hpp"

namespace taut {
namespace {

/// Chance explains no more log likelihood than so much.
constexpr double beyond_chance_gain = 8.0;
constexpr double untenable_gain = 20.0;

constexpr int fewest_lengths = 8;

}  // namespace

bool FoundScale::is_contradicted() const {
    return ratio > 0.0 && std > 0.0 && std::abs(ratio - 1.0) > beyond_chance_std * std;
}

bool LawCheck::has_mean() const {
    return mean_std > 0.0 && std::abs(mean) > beyond_chance_std * mean_std;
}

bool LawCheck::is_contradicted() const {
    return gain > beyond_chance_gain || has_mean() || beyond > 0;
}

bool LawCheck::is_untenable() const {
    return gain > untenable_gain;
}

bool LawCheck::is_too_wide() const {
    constexpr double narrower = 0.8;
    return likeliest.std() < narrower * checked.std();
}

LawCheck check_law_by_lengths(const LengthLaw& law, const LawLikelihood& likelihood) {
    LawCheck result{.checked = law, .lengths = likelihood.count(), .likeliest = law};
    if (result.lengths < fewest_lengths) {
        return result;
    }
    const double of_told = likelihood(law);
    for (const LengthLaw::Kind kind :
         {LengthLaw::Kind::uniform, LengthLaw::Kind::normal, LengthLaw::Kind::bimodal}) {
        const LengthLaw found = likelihood.likeliest(kind);
        if (const double gain = likelihood(found) - of_told; gain > result.gain) {
            result.gain = gain;
            result.likeliest = found;
        }
    }
    return result;
}

}  // namespace taut
