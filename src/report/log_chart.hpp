// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/svg.hpp"

namespace taut::report {

/// A named curve: a positive y for some x of at least 0.
struct LogSeries {
    std::string name;
    std::string style;
    std::map<double, double> points;
};

struct LogChart {
    std::string name;   ///< of the drawing
    std::string title;  ///< likewise
    std::string x_label;
    std::string y_label;
    std::string y_unit;
    bool x_is_linear = false;
};

/// Curves over two logarithmic axes, or over a linear x. On a logarithmic one x = 0 stands on the
/// left, apart from the others and joined to none. There, y may be smaller by many orders than
/// elsewhere: what lies below the others by more than a factor 3 is told in words in a strip at the
/// lower edge, so that the rest can be told apart.
/// @return nothing where there is no point
[[nodiscard]] std::optional<Drawing> log_chart(const LogChart& chart,
                                               const std::vector<LogSeries>& series);

}  // namespace taut::report
