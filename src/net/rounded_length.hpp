// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <string>

#include "taut/net/units.hpp"

namespace taut {

/// A length that was computed, to a few digits, for people: "0.5008mm".
[[nodiscard]] inline std::string rounded_length(double metres, int digit_count = 4) {
    const std::string digits = fmt::format("{:.{}g}", metres, digit_count);
    double rounded = metres;
    fast_float::from_chars(digits.data(), digits.data() + digits.size(), rounded);
    return format_length(rounded);
}

}  // namespace taut
