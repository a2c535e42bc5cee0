// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/result.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// The uncertain parameters, and which of them the survey shows.
/// @param given those that taut did not assume
[[nodiscard]] std::vector<Assumption> assumptions_of(
    const std::vector<UncertainParameter>& uncertain, const std::vector<UncertainParameter>& given,
    const Identification& result);

/// The parameters that taut assumes, their widths known to a factor of 1.5: docs/theory.md,
/// (assumed-width).
/// @param given those that taut did not assume
[[nodiscard]] std::vector<UncertainParameter> with_uncertain_widths(
    std::vector<UncertainParameter> uncertain, const std::vector<UncertainParameter>& given);

/// Reports estimates of a fit with_uncertain_widths() under the widths assumed, but those set free.
/// @param uncertain with the widths assumed
/// @param given those that taut did not assume
void name_assumed_widths(Identification& result, const std::vector<UncertainParameter>& uncertain,
                         const std::vector<UncertainParameter>& given);

}  // namespace taut
