// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/edge_axes.hpp"

#include "report/figures.hpp"

namespace taut::report {

Axes edge_axes(int count, double reach, const std::string& y_label) {
    // Where all is zero, any range shows that.
    const double range = reach > 0.0 ? 1.05 * reach : 1.0;
    return edge_axes(count, {.low = -range, .high = range}, "interior edge i", y_label);
}

Axes edge_axes(int count, const EdgeRange& range, const std::string& x_label,
               const std::string& y_label) {
    constexpr double legend_height = 28.0;
    constexpr double right_margin = 12.0;
    const double border = 0.5 + 0.008 * count;
    Axes axes;
    axes.y = {.low = range.low,
              .high = range.high,
              .from = edge_drawing_height - bottom_margin,
              .to = legend_height};
    axes.y_ticks = nice_ticks(range.low, range.high, 8);
    axes.x = {.low = 1.0 - border,
              .high = count + border,
              .from = left_margin(axes.y_ticks),
              .to = full_width - right_margin};
    // Edges are counted from 1; a mark left of that would be none of them.
    axes.x_ticks = nice_ticks(0.5, count + 0.5, 10, 1.0);
    axes.x_label = x_label;
    axes.y_label = y_label;
    return axes;
}

}  // namespace taut::report
