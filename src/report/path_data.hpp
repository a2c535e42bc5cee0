// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace taut::report {

/// The data of an SVG path, kept short: relative steps in tenths of a unit. Each step is taken from
/// the rounded place before it, so that rounding errors do not add up.
class PathData {
public:
    void move_to(const Eigen::Vector2d& place);
    void line_to(const Eigen::Vector2d& place);
    /// A line of no length: a dot, where the line has round ends.
    void dot(const Eigen::Vector2d& place);

    /// A square with a middle and a width.
    void square(const Eigen::Vector2d& middle, double width);

    [[nodiscard]] bool empty() const { return m_text.empty(); }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    void step(char command, const Eigen::Vector2d& place);

    std::string m_text;
    long m_x = 0;  ///< tenths of a unit
    long m_y = 0;
};

}  // namespace taut::report
