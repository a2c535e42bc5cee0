// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fast_float/fast_float.h>

#include <cmath>
#include <optional>
#include <string_view>

namespace taut {

/// The whole of the text as a finite number, if it is one. It may start with a plus sign.
[[nodiscard]] inline std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = fast_float::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

}  // namespace taut
