// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/result.hpp"
#include "taut/sampling/unknown.hpp"

namespace taut {

/// What was taken as uncertain, and which of it the survey shows.
/// @param given of these what was not assumed by taut
[[nodiscard]] std::vector<Assumption> assumptions_of(const std::vector<Unknown>& uncertain,
                                                     const std::vector<Unknown>& given,
                                                     const Identification& result);

}  // namespace taut
