// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/svg.hpp"
#include "report/ticks.hpp"

namespace taut::report {

/// The key to colours that stand for values from 0 to `largest`.
struct ColourBar {
    double largest = 1.0;
    Ticks ticks;

    /// @param values_largest where it is zero, the bar goes to 1
    explicit ColourBar(double values_largest);

    /// One of so many colours that a value may have: things of one colour can share a path.
    static constexpr int levels = 64;
    [[nodiscard]] int level_of(double value) const;
    [[nodiscard]] static std::string colour_of(int level);

    /// Room that it takes with its labels and the distance to what stands on its left.
    [[nodiscard]] double room() const;

    /// Draws it to the right of a place, as high as what stands on its left.
    void draw(SvgBody& svg, const Eigen::Vector2d& top_left, double height) const;
};

}  // namespace taut::report
