// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/colour_bar.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "report/axes.hpp"
#include "report/colour_map.hpp"

namespace taut::report {
namespace {

constexpr double distance = 14.0;
constexpr double bar_width = 12.0;
/// Between the bar and its labels.
constexpr double gap = 7.0;
/// Labels get this much at least, so that drawings side by side agree in size.
constexpr double least_label_room = 40.0;

}  // namespace

ColourBar::ColourBar(double values_largest)
    : largest(values_largest > 0.0 ? values_largest : 1.0), ticks(nice_ticks(0.0, largest, 6)) {}

int ColourBar::level_of(double value) const {
    return static_cast<int>(std::clamp(levels * value / largest, 0.0, levels - 1.0));
}

std::string ColourBar::colour_of(int level) {
    return viridis((level + 0.5) / levels);
}

double ColourBar::room() const {
    double label_room = least_label_room;
    for (const std::string& label : ticks.labels) {
        label_room = std::max(label_room, text_width(label));
    }
    // The wider letters of some fonts need a little more than is estimated.
    return distance + bar_width + 2.0 * gap + label_room;
}

void ColourBar::draw(SvgBody& svg, const Eigen::Vector2d& top_left, double height) const {
    const Eigen::Vector2d corner = top_left + Eigen::Vector2d(distance, 0.0);
    const double right = corner.x() + bar_width;
    // Two levels a rectangle are enough for the eye.
    constexpr int steps = levels / 2;
    for (int i = 0; i < steps; ++i) {
        const double y = corner.y() + height * (1.0 - (i + 1.0) / steps);
        // Each overlaps the one below a little, or thin lines would show between them.
        const double overlap = i == 0 ? 0.0 : 0.5;
        svg.rectangle("level", {corner.x(), y}, {bar_width, height / steps + overlap},
                      fmt::format("fill=\"{}\"", viridis((i + 0.5) / steps)));
    }
    svg.rectangle("frame", corner, {bar_width, height});
    const Scale scale{.low = 0.0, .high = largest, .from = corner.y() + height, .to = corner.y()};
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = scale(ticks.values[i]);
        svg.line("frame", {right, y}, {right + 4.0, y});
        svg.text({right + gap, y + 4.0}, ticks.labels[i]);
    }
}

}  // namespace taut::report
