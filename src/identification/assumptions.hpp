// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/result.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// What was taken as uncertain, and which of it the survey shows.
/// @param given of these what was not assumed by taut
[[nodiscard]] std::vector<Assumption> assumptions_of(
    const std::vector<UncertainParameter>& uncertain, const std::vector<UncertainParameter>& given,
    const Identification& result);

/// What taut assumes, each width known to a factor of 1.5: docs/theory.md, (assumed-width).
/// @param given of these what was not assumed by taut, and stays as it is
[[nodiscard]] std::vector<UncertainParameter> with_uncertain_widths(
    std::vector<UncertainParameter> uncertain, const std::vector<UncertainParameter>& given);

/// Names estimates of a fit with_uncertain_widths() by the widths that were assumed.
void name_assumed_widths(Identification& result, const std::vector<UncertainParameter>& given);

}  // namespace taut
