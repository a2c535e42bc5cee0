// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <string>

#include "taut/net/units.hpp"

namespace taut {

/// A value rounded to a number of significant digits, for messages.
[[nodiscard]] inline double to_digits(double value, int digit_count) {
    const std::string digits = fmt::format("{:.{}g}", value, digit_count);
    fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// A computed length as text, rounded likewise: "0.5008mm".
[[nodiscard]] inline std::string rounded_length(double metres, int digit_count = 4) {
    return format_length(to_digits(metres, digit_count));
}

}  // namespace taut
