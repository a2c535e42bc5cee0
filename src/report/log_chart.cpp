// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/log_chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

/// Of the decades between the least and the largest positive x, the part that 0 stands apart.
constexpr double zero_gap = 0.25;

/// Where an x stands on a linear axis, or on a logarithmic one: there 0 is apart on the left.
class ChartPlaces {
public:
    ChartPlaces(const std::vector<LogSeries>& series, bool linear) : m_linear(linear) {
        for (const LogSeries& s : series) {
            for (const auto& [x, y] : s.points) {
                m_values.insert(x);
            }
        }
        const auto first = m_values.upper_bound(0.0);
        if (first != m_values.end()) {
            m_low = std::log10(*first);
            m_high = std::log10(*m_values.rbegin());
        }
    }

    [[nodiscard]] const std::set<double>& values() const { return m_values; }
    [[nodiscard]] bool is_apart(double x) const { return !m_linear && !(x > 0.0); }
    [[nodiscard]] double operator()(double x) const {
        if (m_linear) {
            return x;
        }
        return x > 0.0 ? std::log10(x) : m_low - zero_gap * std::max(m_high - m_low, 1.0);
    }

private:
    bool m_linear;
    std::set<double> m_values;
    double m_low = 0.0;
    double m_high = 0.0;
};

/// Below this a point is told in words.
double lowest_drawn(const std::vector<LogSeries>& series, const ChartPlaces& places) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const LogSeries& s : series) {
        for (const auto& [x, y] : s.points) {
            lowest = places.is_apart(x) ? lowest : std::min(lowest, y);
        }
    }
    constexpr double factor = 3.0;
    return std::isfinite(lowest) ? lowest / factor : 0.0;
}

/// Heights of a line of words, and of the strip at the lower edge that holds so many.
constexpr double word_height = 18.0;

double strip_height(const std::vector<LogSeries>& series, double lowest) {
    std::ptrdiff_t lines = 0;
    for (const LogSeries& s : series) {
        lines += std::ranges::count_if(s.points, [=](const auto& p) { return p.second < lowest; });
    }
    return lines > 0 ? word_height * (static_cast<double>(lines) + 0.5) : 0.0;
}

Axes log_axes(const LogChart& chart, const std::vector<LogSeries>& series,
              const ChartPlaces& places, double lowest, double top, double height) {
    double low_y = std::numeric_limits<double>::infinity();
    double high_y = -std::numeric_limits<double>::infinity();
    for (const LogSeries& s : series) {
        for (const auto& [x, y] : s.points) {
            low_y = y >= lowest ? std::min(low_y, std::log10(y)) : low_y;
            high_y = std::max(high_y, std::log10(y));
        }
    }
    Axes axes;
    constexpr double margin = 0.1;
    axes.y = {
        .low = low_y - margin, .high = high_y + margin, .from = height - bottom_margin, .to = top};
    axes.y_ticks = decade_ticks(axes.y.low, axes.y.high);
    // The strip of words has no scale: no point of a curve lies there.
    const double strip = std::min(0.5, strip_height(series, lowest) / (axes.y.from - axes.y.to));
    axes.y.low -= (axes.y.high - axes.y.low) * strip / (1.0 - strip);
    const double first = places(*places.values().begin());
    const double last = places(*places.values().rbegin());
    const double room = 0.08 * std::max(last - first, 1.0);
    axes.x = {.low = first - room,
              .high = last + room,
              .from = left_margin(axes.y_ticks),
              .to = half_width - 12.0};
    double free_from = -std::numeric_limits<double>::infinity();
    for (const double x : places.values()) {
        const std::string label = short_number(x);
        const double half = 0.5 * text_width(label);
        if (axes.x(places(x)) - half >= free_from) {
            axes.x_ticks.values.push_back(places(x));
            axes.x_ticks.labels.push_back(label);
            free_from = axes.x(places(x)) + half + 4.0;
        }
    }
    axes.x_label = chart.x_label;
    axes.y_label = fmt::format("{} [{}]", chart.y_label, chart.y_unit);
    return axes;
}

}  // namespace

std::optional<Drawing> log_chart(const LogChart& chart, const std::vector<LogSeries>& series) {
    const ChartPlaces places(series, chart.x_is_linear);
    if (places.values().empty()) {
        return std::nullopt;
    }
    constexpr double plot_height = 280.0;
    const double top = 10.0 + word_height * static_cast<double>(series.size());
    const double height = top + plot_height;
    const double lowest = lowest_drawn(series, places);
    const Axes axes = log_axes(chart, series, places, lowest, top, height);
    SvgBody svg;
    draw_axes(svg, axes, true);
    double legend_y = 16.0;
    double word_y = axes.y.from - 8.0;
    double width = 1.4 + 0.7 * static_cast<double>(series.size());
    for (const LogSeries& s : series) {
        // Thinner from curve to curve: of two in one place both are seen.
        width -= 0.7;
        const std::string is_wide = fmt::format("style=\"stroke-width:{:.1f}\"", width);
        const std::string is_dot = fmt::format("style=\"stroke-width:{:.1f}\"", width + 4.0);
        draw_legend(
            svg, {axes.x.from, legend_y},
            {{.style = s.style, .words = s.name, .mark = Mark::dash, .attributes = is_wide}});
        legend_y += word_height;
        PathData line;
        PathData dots;
        bool is_joined = false;
        for (const auto& [x, y] : s.points) {
            if (y < lowest) {
                PathData mark;
                mark.dot({axes.x(places(x)), word_y - 4.0});
                svg.path(s.style, mark, is_dot);
                svg.text({axes.x(places(x)) + 8.0, word_y},
                         fmt::format("{} {}", short_number(y), chart.y_unit));
                word_y -= word_height;
                continue;
            }
            const Eigen::Vector2d place = axes(places(x), std::log10(y));
            is_joined ? line.line_to(place) : line.move_to(place);
            is_joined = !places.is_apart(x);
            dots.dot(place);
        }
        svg.path(s.style, line, is_wide);
        svg.path(s.style, dots, is_dot);
    }
    return Drawing{.name = chart.name,
                   .title = chart.title,
                   .width = half_width,
                   .height = height,
                   .body = svg.take()};
}

}  // namespace taut::report
