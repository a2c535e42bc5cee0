// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/units.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace taut {
namespace {

/// Units in so many to a metre: 5 / 1000 is the double next to 0.005, which 5 * 0.001 is not.
constexpr std::array<std::pair<std::string_view, double>, 4> lengths_per_metre{
    {{"mm", 1000.0}, {"cm", 100.0}, {"m", 1.0}, {"", 1.0}}};

}  // namespace

double parse_length(std::string_view text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && std::isfinite(value)) {
        std::string_view unit(rest, static_cast<size_t>(end - rest));
        while (unit.starts_with(' ')) {
            unit.remove_prefix(1);
        }
        for (const auto& [name, per_metre] : lengths_per_metre) {
            if (unit == name) {
                return value / per_metre;
            }
        }
    }
    throw std::invalid_argument(fmt::format(
        "'{}' is no length: expected a number and a unit, as in 5mm, 0.5cm or 0.005m", text));
}

std::string format_length(double metres) {
    // The product is rounded: of 63.7 / 1000 it is 63.70000000000001, and both read back alike.
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        const std::string text = fmt::format("{:.{}e}", metres * 1000.0, digits - 1);
        double millimetres = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), millimetres);
        if (millimetres / 1000.0 == metres) {
            return fmt::format("{}mm", millimetres);
        }
    }
    return fmt::format("{}m", metres);
}

}  // namespace taut
