// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/units.hpp"

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace taut {
namespace {

/// A unit and its size: `per_base` units make a base unit (1000 mm are 1 m), or one unit is `bases`
/// base units (1 kN is 1000 N). Whichever is a whole number is given, since 5 / 1000 is the double
/// nearest to 0.005, and 5 * 0.001 is not.
struct Unit {
    std::string_view name;
    double per_base = 1.0;
    double bases = 1.0;
};

constexpr std::array lengths{Unit{.name = "mm", .per_base = 1e3},
                             Unit{.name = "cm", .per_base = 1e2}, Unit{.name = "m"},
                             Unit{.name = ""}};
constexpr std::array forces{Unit{.name = "N"}, Unit{.name = "kN", .bases = 1e3},
                            Unit{.name = "MN", .bases = 1e6}, Unit{.name = ""}};
constexpr std::array stresses{Unit{.name = "Pa"},
                              Unit{.name = "kPa", .bases = 1e3},
                              Unit{.name = "MPa", .bases = 1e6},
                              Unit{.name = "GPa", .bases = 1e9},
                              Unit{.name = "N/mm2", .bases = 1e6},
                              Unit{.name = ""}};
constexpr std::array parts{Unit{.name = "%", .per_base = 1e2}};
constexpr std::array temperatures{Unit{.name = "K"}};
constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
constexpr std::array memory{
    Unit{.name = "MB", .bases = 1e6},  Unit{.name = "MiB", .bases = gibibyte / 1024.0},
    Unit{.name = "GB", .bases = 1e9},  Unit{.name = "GiB", .bases = gibibyte},
    Unit{.name = "TB", .bases = 1e12}, Unit{.name = "TiB", .bases = 1024.0 * gibibyte}};

/// More than anything built has, in every SI unit, and any machine's bytes.
constexpr double largest_quantity = 1e15;

/// @param is_no the kind of quantity, and what was expected, for the message
template <size_t Count>
double parse_quantity(std::string_view text, const std::array<Unit, Count>& units,
                      std::string_view is_no) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = fast_float::from_chars(text.data(), end, value);
    if (error == std::errc() && std::isfinite(value)) {
        std::string_view name(rest, end - rest);
        while (name.starts_with(' ')) {
            name.remove_prefix(1);
        }
        for (const Unit& unit : units) {
            const double in_base = value / unit.per_base * unit.bases;
            if (name == unit.name && std::abs(in_base) <= largest_quantity) {
                return in_base;
            }
        }
    }
    throw std::invalid_argument(fmt::format("'{}' is no {}", text, is_no));
}

/// @param tolerance relative error of the length that is read back
std::string shortest_text(double metres, double tolerance) {
    // The product is rounded: for 63.7 / 1000 it is 63.70000000000001. Both are read back as the
    // same length, so fewer digits are tried first.
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        const std::string text = fmt::format("{:.{}e}", metres * 1000.0, digits - 1);
        double millimetres = 0.0;
        fast_float::from_chars(text.data(), text.data() + text.size(), millimetres);
        if (std::abs(millimetres / 1000.0 - metres) <= tolerance * std::abs(metres)) {
            return fmt::format("{}mm", millimetres);
        }
    }
    return fmt::format("{}m", metres);
}

}  // namespace

double parse_length(std::string_view text) {
    return parse_quantity(text, lengths,
                          "length: expected a number and a unit, as in 5mm, 0.5cm or 0.005m");
}

double parse_force(std::string_view text) {
    return parse_quantity(text, forces,
                          "force: expected a number and a unit, as in 200kN, 0.2MN or 50N");
}

double parse_stress(std::string_view text) {
    return parse_quantity(
        text, stresses,
        "stress: expected a number and a unit, as in 205GPa, 205000MPa or 2.05e11Pa");
}

std::string format_length(double metres) {
    constexpr double rounding = 1e-12;
    return shortest_text(metres, rounding);
}

std::string format_length_exactly(double metres) {
    return shortest_text(metres, 0.0);
}

double parse_part(std::string_view text) {
    return parse_quantity(text, parts, "percentage: expected a number and %, as in 5%");
}

double parse_memory(std::string_view text) {
    return parse_quantity(
        text, memory, "size of memory: expected a number with MB, MiB, GB, GiB, TB or TiB: 8GiB");
}

double parse_temperature(std::string_view text) {
    return parse_quantity(text, temperatures,
                          "difference of temperatures: expected a number and K, as in 10K");
}

}  // namespace taut
