// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// What a survey tells of one edge.
enum class EdgeStatus {
    identified,
    slack,       ///< carries no tension in the predicted form: its length shows in nothing
    unobserved,  ///< no narrower known than before the survey
};

/// "identified", "slack", "unobserved".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(EdgeStatus status);

/// An edge is unobserved when its standard deviation exceeds this part of that of the law of its
/// length: two Gaussian processes trained on other samples differ by as much.
inline constexpr double unobserved_ratio = 0.95;

/// Half the width of the 95 % interval of a normal distribution, in standard deviations.
inline constexpr double half_interval_95 = 1.959963984540054;

}  // namespace taut
