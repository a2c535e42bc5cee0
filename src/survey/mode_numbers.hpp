// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/survey/cable_frequency.hpp"

namespace taut {

/// Fundamentals that may explain peaks, likeliest first, each with its probability: docs/theory.md,
/// (mode numbers). Of those that number no peak differently the likeliest is kept.
/// @param peaks ascending in frequency, at least one
/// @param range of f_0
/// @param is_certain whether one of them is right; else the peaks may be of no cable
[[nodiscard]] TAUT_CORE_EXPORT std::vector<Fundamental> number_modes(
    const std::vector<FrequencyPeak>& peaks, const FrequencyRange& range, bool is_certain);

}  // namespace taut
