// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

using Row = ComparisonResult::Row;
/// Median over the rows that share a place on the x axis: noise [mm] or samples, error [mm].
using Curve = std::map<double, double>;

Curve curve(const std::vector<Row>& rows, const std::function<std::optional<double>(const Row&)>& x,
            const std::function<std::optional<double>(const Row&)>& mse) {
    std::map<double, std::vector<double>> found;
    for (const Row& row : rows) {
        const auto place = x(row);
        const auto value = mse(row);
        if (place && value && *value > 0.0) {
            found[*place].push_back(1e3 * std::sqrt(*value));
        }
    }
    Curve result;
    for (auto& [place, values] : found) {
        std::ranges::sort(values);
        result[place] = values[values.size() / 2];
    }
    return result;
}

/// Marks at powers of ten and, where there are few of them, at twice and five times these.
Ticks log_ticks(double low, double high) {
    Ticks ticks;
    const int first = static_cast<int>(std::floor(low));
    const int last = static_cast<int>(std::ceil(high));
    const std::vector<double> mantissas =
        last - first <= 3 ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0};
    for (int power = first; power <= last; ++power) {
        for (const double mantissa : mantissas) {
            const double value = std::log10(mantissa) + power;
            if (value >= low && value <= high) {
                ticks.values.push_back(value);
                ticks.labels.push_back(short_number(mantissa * std::pow(10.0, power)));
            }
        }
    }
    return ticks;
}

struct Series {
    std::string name;
    std::string style;
    Curve points;
};

std::optional<Drawing> drawing(const std::vector<Series>& series, const std::string& name,
                               const std::string& title, const std::string& x_label) {
    double low_y = INFINITY;
    double high_y = -INFINITY;
    std::map<double, int> places;  // the values on the x axis, evenly spaced
    for (const Series& s : series) {
        for (const auto& [x, y] : s.points) {
            low_y = std::min(low_y, std::log10(y));
            high_y = std::max(high_y, std::log10(y));
            places[x] = 0;
        }
    }
    if (places.empty()) {
        return std::nullopt;
    }
    Axes axes;
    constexpr double legend_line_height = 18.0;
    const double top = 10.0 + legend_line_height * static_cast<double>(series.size());
    const double height = top + 280.0;
    axes.y = {.low = low_y - 0.1, .high = high_y + 0.1, .from = height - bottom_margin, .to = top};
    axes.y_ticks = log_ticks(axes.y.low, axes.y.high);
    int next = 0;
    for (auto& [x, place] : places) {
        place = next++;
        axes.x_ticks.values.push_back(place);
        axes.x_ticks.labels.push_back(short_number(x));
    }
    axes.x = {.low = -0.4,
              .high = next - 0.6,
              .from = left_margin(axes.y_ticks),
              .to = half_width - 12.0};
    axes.x_label = x_label;
    axes.y_label = "root mean squared error [mm]";
    SvgBody svg;
    draw_axes(svg, axes, true);
    double legend_y = 16.0;
    for (const Series& s : series) {
        const std::string dots = "style=\"stroke-width:6\"";
        draw_legend(svg, {axes.x.from, legend_y},
                    {{.style = s.style, .words = s.name, .mark = Mark::dash}});
        legend_y += legend_line_height;
        PathData line;
        PathData marks;
        for (const auto& [x, y] : s.points) {
            const Eigen::Vector2d place = axes(places[x], std::log10(y));
            line.empty() ? line.move_to(place) : line.line_to(place);
            marks.dot(place);
        }
        svg.path(s.style, line);
        svg.path(s.style, marks, dots);
    }
    return Drawing{
        .name = name, .title = title, .width = half_width, .height = height, .body = svg.take()};
}

/// A curve for each method in the order of the file, then the best possible.
std::vector<Series> series_over(const ComparisonResult& comparison, const std::vector<Row>& rows,
                                const std::function<std::optional<double>(const Row&)>& x) {
    std::vector<Series> series;
    for (const Row& row : comparison.rows) {
        const auto of_method = [&row](const Series& s) { return s.name == row.method; };
        if (std::ranges::any_of(series, of_method)) {
            continue;
        }
        std::vector<Row> own;
        std::ranges::copy_if(rows, std::back_inserter(own),
                             [&row](const Row& r) { return r.method == row.method; });
        series.push_back({.name = row.method,
                          .style = fmt::format("series{}", series.size() % 6),
                          .points = curve(own, x, [](const Row& r) { return r.mse; })});
    }
    series.push_back({.name = "best possible",
                      .style = "best",
                      .points = curve(rows, x, [](const Row& r) { return r.best_possible_mse; })});
    std::erase_if(series, [](const Series& s) { return s.points.empty(); });
    return series;
}

/// The rows of the most training samples (and of methods without training), or of the most common
/// noise, with no node hidden unless all rows hide some.
std::vector<Row> visible(const std::vector<Row>& rows) {
    const double least =
        std::ranges::min(rows, {}, [](const Row& r) { return r.hidden_fraction; }).hidden_fraction;
    std::vector<Row> result;
    std::ranges::copy_if(rows, std::back_inserter(result),
                         [least](const Row& r) { return r.hidden_fraction <= least; });
    return result;
}

}  // namespace

Figure comparison_figure(const ComparisonResult& comparison) {
    const std::vector<Row> rows = visible(comparison.rows);
    double most_samples = 0.0;
    std::map<double, int> noises;
    for (const Row& row : rows) {
        most_samples = std::max(most_samples, row.training_samples.value_or(0.0));
        noises[row.noise] += row.training_samples ? 1 : 0;
    }
    // Among noises with as many rows the lowest that is none: surveys without noise do not exist.
    const double noise = std::ranges::max_element(noises, {}, [](const auto& entry) {
                             return std::tuple(entry.second, entry.first > 0.0, -entry.first);
                         })->first;
    std::vector<Row> over_noise;
    std::vector<Row> over_training;
    for (const Row& row : rows) {
        if (row.training_samples.value_or(most_samples) == most_samples) {
            over_noise.push_back(row);
        }
        if (row.noise == noise) {
            over_training.push_back(row);
        }
    }
    Figure figure{.heading = "Error of each method"};
    const auto add = [&figure](std::optional<Drawing> drawn) {
        if (drawn) {
            figure.drawings.push_back(*std::move(drawn));
        }
    };
    add(drawing(series_over(comparison, over_noise,
                            [](const Row& r) { return std::optional(1e3 * r.noise); }),
                "error_over_noise", "Error of each method over the noise of the survey",
                "noise of a surveyed coordinate [mm]"));
    add(drawing(
        series_over(comparison, over_training, [](const Row& r) { return r.training_samples; }),
        "error_over_training", "Error of each method over the number of training samples",
        fmt::format("training samples, at a noise of {} mm", short_number(1e3 * noise))));
    figure.caption =
        "Root of the mean squared error of the identified lengths. The best possible is the "
        "posterior standard deviation of the linearised problem: no method can do better in the "
        "mean.";
    return figure;
}

}  // namespace taut::report
