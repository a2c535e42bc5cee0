// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// How well a survey determines the length of an edge.
enum class EdgeStatus {
    determined,         ///< standard deviation below half of that before the survey
    weakly_determined,  ///< half to nine tenths
    not_determined,     ///< more: hardly better known than before the survey
    slack,  ///< carries no tension in the predicted form: only a lower bound of its length is known
};

/// "determined", "weakly_determined", "not_determined", "slack".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(EdgeStatus status);

/// A number is determined by a survey where its standard deviation is below this part of that
/// before the survey.
inline constexpr double determined_ratio = 0.5;
/// From this part on it is not determined; between, weakly.
inline constexpr double not_determined_ratio = 0.9;

/// The status by that rule, for a number that is not slack. Standard deviations are not checked.
[[nodiscard]] TAUT_CORE_EXPORT EdgeStatus status_of(double prior_std, double std_dev);

/// Half the width of the 95 % interval of a normal distribution, in standard deviations.
inline constexpr double half_interval_95 = 1.959963984540054;

}  // namespace taut
