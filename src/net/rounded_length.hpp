// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <string>

#include "taut/net/units.hpp"

namespace taut {

/// A length that was computed, to four digits, for people: "0.5008mm".
[[nodiscard]] inline std::string rounded_length(double metres) {
    return format_length(std::stod(fmt::format("{:.4g}", metres)));
}

}  // namespace taut
