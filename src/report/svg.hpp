// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>

#include "report/path_data.hpp"

namespace taut::report {

/// A drawing that needs a style sheet (figure_style()) to be seen.
struct Drawing {
    std::string name;   ///< a file's, without its ending
    std::string title;  ///< for those who cannot see it
    double width = 0.0;
    double height = 0.0;
    std::string body;  ///< SVG elements
    /// More attributes of the svg element: how the page finds what it shows (see chart.hpp).
    std::string attributes;
};

/// Collects SVG elements. Places are in units of the drawing, y downwards; `style` is a class of
/// figure_style().
class SvgBody {
public:
    enum class Anchor { start, middle, end };

    /// @param attributes more of them, as they stand in SVG; nothing from outside
    void path(std::string_view style, const PathData& data, std::string_view attributes = {});
    void line(std::string_view style, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void rectangle(std::string_view style, const Eigen::Vector2d& corner,
                   const Eigen::Vector2d& size, std::string_view attributes = {});
    /// @param text is escaped
    void text(const Eigen::Vector2d& place, std::string_view text, Anchor anchor = Anchor::start);
    /// Text that reads upwards, centred at a place.
    void upward_text(const Eigen::Vector2d& place, std::string_view text);

    [[nodiscard]] std::string take() { return std::move(m_body); }

private:
    std::string m_body;
};

/// As an element of an HTML page.
[[nodiscard]] std::string inline_svg(const Drawing& drawing);

/// As a file of its own, on white.
[[nodiscard]] std::string standalone_svg(const Drawing& drawing);

}  // namespace taut::report
