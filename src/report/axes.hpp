// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/svg.hpp"
#include "report/ticks.hpp"

namespace taut::report {

/// Maps values to places along one direction of a drawing, linearly.
struct Scale {
    double low = 0.0;  ///< value at `from`; below `high`
    double high = 1.0;
    double from = 0.0;  ///< place of `low` in the drawing
    double to = 1.0;

    [[nodiscard]] double operator()(double value) const {
        return from + (value - low) / (high - low) * (to - from);
    }
};

/// Two axes around a rectangle of the drawing. The y scale runs upwards: y.from > y.to.
struct Axes {
    Scale x;
    Scale y;
    Ticks x_ticks;
    Ticks y_ticks;
    std::string x_label;  ///< with its unit
    std::string y_label;

    [[nodiscard]] Eigen::Vector2d operator()(double x_value, double y_value) const {
        return {x(x_value), y(y_value)};
    }
};

/// Room that labels take on the left of an axis, and below one.
[[nodiscard]] double left_margin(const Ticks& y_ticks);
inline constexpr double bottom_margin = 42.0;

/// Draws frame, marks and labels; a grid behind what follows if asked to.
void draw_axes(SvgBody& svg, const Axes& axes, bool grid);

/// Estimated width of a text in the style's font.
[[nodiscard]] double text_width(std::string_view text);

/// What a style means.
enum class Mark { dot, square, dash };
struct LegendEntry {
    std::string style;
    std::string words;
    Mark mark = Mark::dot;
    std::string attributes;  ///< of the mark, as in SvgBody::path()
};

/// Writes what styles mean in one row, each with a mark of its style.
/// @param place where the first mark stands, on the line of the text
void draw_legend(SvgBody& svg, const Eigen::Vector2d& place,
                 const std::vector<LegendEntry>& entries);

}  // namespace taut::report
