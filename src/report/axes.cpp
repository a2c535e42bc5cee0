// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/axes.hpp"

#include <algorithm>

namespace taut::report {
namespace {

constexpr double mark_length = 5.0;
constexpr double line_height = 16.0;
using Anchor = SvgBody::Anchor;

}  // namespace

double text_width(std::string_view text) {
    const auto starts_character = [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    };
    // 0.56 em is a little more than the mean of common sans-serif fonts.
    return 6.7 * static_cast<double>(std::ranges::count_if(text, starts_character));
}

double left_margin(const Ticks& y_ticks) {
    double widest = 0.0;
    for (const std::string& label : y_ticks.labels) {
        widest = std::max(widest, text_width(label));
    }
    return widest + mark_length + line_height + 8.0;
}

void draw_axes(SvgBody& svg, const Axes& axes, bool grid) {
    const auto& [x, y, x_ticks, y_ticks, x_label, y_label] = axes;
    for (std::size_t i = 0; i < x_ticks.values.size(); ++i) {
        const double place = x(x_ticks.values[i]);
        if (grid) {
            svg.line("grid", {place, y.from}, {place, y.to});
        }
        svg.line("frame", {place, y.from}, {place, y.from + mark_length});
        svg.text({place, y.from + mark_length + 13.0}, x_ticks.labels[i], Anchor::middle);
    }
    for (std::size_t i = 0; i < y_ticks.values.size(); ++i) {
        const double place = y(y_ticks.values[i]);
        if (grid) {
            svg.line("grid", {x.from, place}, {x.to, place});
        }
        svg.line("frame", {x.from - mark_length, place}, {x.from, place});
        svg.text({x.from - mark_length - 3.0, place + 4.0}, y_ticks.labels[i], Anchor::end);
    }
    svg.rectangle("frame", {x.from, y.to}, {x.to - x.from, y.from - y.to});
    svg.text({0.5 * (x.from + x.to), y.from + bottom_margin - 6.0}, x_label, Anchor::middle);
    svg.upward_text({x.from - left_margin(y_ticks) + 12.0, 0.5 * (y.from + y.to)}, y_label);
}

void draw_legend(SvgBody& svg, const Eigen::Vector2d& place,
                 const std::vector<LegendEntry>& entries) {
    constexpr double dash_length = 16.0;
    Eigen::Vector2d at = place;
    for (const LegendEntry& entry : entries) {
        const double length = entry.mark == Mark::dash ? dash_length : 0.0;
        PathData mark;
        const Eigen::Vector2d start(at.x() + 3.0, at.y() - 4.0);
        if (entry.mark == Mark::square) {
            mark.square(start, 4.2);
        } else {
            mark.move_to(start);
            mark.line_to(start + Eigen::Vector2d(length, 0.0));
        }
        svg.path(entry.style, mark, entry.attributes);
        svg.text({at.x() + length + 10.0, at.y()}, entry.words);
        at.x() += length + 10.0 + text_width(entry.words) + 14.0;
    }
}

}  // namespace taut::report
