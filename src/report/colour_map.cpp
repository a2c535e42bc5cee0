// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/colour_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::report {
namespace {

using Colour = std::array<int, 3>;

/// Viridis at 0, 1/8, ..., 1; between these it is nearly linear.
constexpr std::array<Colour, 9> anchors{{{68, 1, 84},
                                         {71, 45, 123},
                                         {59, 82, 139},
                                         {44, 114, 142},
                                         {33, 145, 140},
                                         {40, 174, 128},
                                         {94, 201, 98},
                                         {173, 220, 48},
                                         {253, 231, 37}}};

}  // namespace

std::string viridis(double position) {
    // The comparison is false for NaN too, which then takes the low end.
    const double inside = position > 0.0 ? std::min(position, 1.0) : 0.0;
    const double place = inside * static_cast<double>(anchors.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double part = place - static_cast<double>(below);
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = static_cast<int>(
            std::lround((1.0 - part) * anchors[below][i] + part * anchors[below + 1][i]));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

}  // namespace taut::report
