// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "report/axes.hpp"

namespace taut::report {

/// Axes of a full-width drawing over the interior edges i = 1, ..., count, with a length in
/// millimetres upwards.
/// @param reach the y axis goes from -reach to +reach, and a little beyond [mm]
[[nodiscard]] Axes edge_axes(int count, double reach, const std::string& y_label);

/// What goes upwards over edges i = 1, ..., count: values from `low` to `high`.
struct EdgeRange {
    double low = 0.0;
    double high = 1.0;
};
[[nodiscard]] Axes edge_axes(int count, const EdgeRange& range, const std::string& x_label,
                             const std::string& y_label);

/// Height of such a drawing, and where its legend stands.
inline constexpr double edge_drawing_height = 360.0;
inline constexpr double edge_legend_y = 16.0;

}  // namespace taut::report
