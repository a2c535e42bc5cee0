// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/sampling/length_law.hpp"

namespace taut {

/// A scale that a survey shows, of what was told.
struct FoundScale {
    double ratio = 1.0;  ///< found over told; 0 where the survey does not show it
    double std = 0.0;    ///< of the ratio, if what was told is true

    /// Beyond chance: the probability of that is below 1 in 10,000 where what was told is true.
    [[nodiscard]] bool is_contradicted() const;
};

/// The scales by which noise and lengths together fit what a survey shows.
struct VarianceComponents {
    FoundScale noise;
    FoundScale lengths;
};

/// What the lengths that a survey shows tell of their law.
struct LawCheck {
    int lengths = 0;        ///< that it rests on
    LengthLaw likeliest;    ///< of uniform, normal and bimodal, of any scale
    double gain = 0.0;      ///< of its log likelihood over that of the law told
    double mean = 0.0;      ///< that all deviations have in common [m]
    double mean_std = 0.0;  ///< of that, if it is none [m]
    int beyond = 0;         ///< edges beyond the law, where these were too many to be mis-cut

    /// Whether the mean is none that chance would give.
    [[nodiscard]] bool has_mean() const;
    /// Whether another law is so much likelier that the one told is not to be relied on.
    [[nodiscard]] bool is_contradicted() const;
};

}  // namespace taut
