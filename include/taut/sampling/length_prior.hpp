// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// The prior distribution of the length deviations (fabrication tolerance): independent, the same
/// for every interior edge, with mean zero.
struct TAUT_CORE_EXPORT LengthPrior {
    /// Shape of the distribution.
    enum class Kind {
        uniform,  ///< U(-scale, scale), the paper's
        normal,   ///< N(0, scale^2)
        bimodal,  ///< N(-scale, (scale/5)^2) or N(+scale, (scale/5)^2), equally likely
    };
    Kind kind = Kind::uniform;  ///< shape
    double scale = 0.005;       ///< [m]

    /// Checks that the scale is positive and finite; the functions below rely on it.
    /// @throws std::invalid_argument naming prior and scale
    void check() const;

    /// Standard deviation [m].
    [[nodiscard]] double std_dev() const;

    /// No deviation drawn exceeds this [m].
    [[nodiscard]] double reach() const;

    /// The quantile at u in (0, 1): of a uniform random number a draw from the prior [m].
    [[nodiscard]] double draw(double u) const;

    friend bool operator==(const LengthPrior&,
                           const LengthPrior&) = default;  ///< by shape and scale
};

/// "uniform:5mm"; parse_length_prior() reads it back.
[[nodiscard]] TAUT_CORE_EXPORT std::string to_string(const LengthPrior& prior);

/// "uniform:5mm", "normal:2mm", "bimodal:5mm".
/// @throws std::invalid_argument for another name, or a scale that is not a positive length
[[nodiscard]] TAUT_CORE_EXPORT LengthPrior parse_length_prior(std::string_view text);

}  // namespace taut
