// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/node_map.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

/// The standardised residuals of the targets in use, coordinate by coordinate.
std::vector<double> standardised(const IdentificationResult& result) {
    std::vector<double> values;
    for (const auto& residual : result.residuals) {
        if (residual.is_in_use && residual.standardised) {
            values.insert(values.end(), residual.standardised->begin(),
                          residual.standardised->end());
        }
    }
    return values;
}

/// Bins of one width over [-reach, reach]; what lies beyond is counted at the ends.
std::vector<double> histogram(const std::vector<double>& values, double reach, int bins) {
    std::vector<double> counts(bins, 0.0);
    for (const double value : values) {
        const double place = std::clamp((value / reach + 1.0) * 0.5 * bins, 0.0, bins - 1.0);
        counts[static_cast<size_t>(place)] += 1.0;
    }
    return counts;
}

/// The standard normal law, as high as so many values in bins of a width are.
PathData normal_curve(const Axes& axes, double count, double bin_width) {
    PathData path;
    constexpr int steps = 120;
    for (int i = 0; i <= steps; ++i) {
        const double x = axes.x.low + (axes.x.high - axes.x.low) * i / steps;
        const double y =
            count * bin_width * std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
        i == 0 ? path.move_to(axes(x, y)) : path.line_to(axes(x, y));
    }
    return path;
}

int left_out_count(const IdentificationResult& result) {
    return static_cast<int>(
        std::ranges::count(result.residuals, false, &IdentificationResult::Residual::is_in_use));
}

}  // namespace

Figure residual_map_figure(const IdentificationResult& result) {
    Figure figure{.heading = "Predicted against surveyed form"};
    NodeMap map{.name = "residual_map",
                .title = "Distance between surveyed and predicted nodes, in plan",
                .heading = "surveyed to predicted [mm]"};
    std::vector<double> in_use;
    double farthest_left_out = 0.0;
    for (const auto& residual : result.residuals) {
        const double distance = 1e3 * residual.surveyed_less_predicted.norm();
        if (residual.is_in_use) {
            map.nodes.push_back(residual.node);
            in_use.push_back(distance);
        } else {
            map.marked.push_back(residual.node);
            farthest_left_out = std::max(farthest_left_out, distance);
        }
    }
    if (in_use.empty()) {
        return figure;
    }
    map.values = Eigen::VectorXd::Map(in_use.data(), static_cast<Eigen::Index>(in_use.size()));
    map.largest = map.values.maxCoeff();
    figure.drawings = {node_map_drawing(result.net, result.form, map)};
    const double rms = std::sqrt(map.values.squaredNorm() / static_cast<double>(in_use.size()));
    figure.caption = fmt::format(
        "Distance between the surveyed place of {} and the form that the identified lengths give: "
        "{} mm RMS, at most {} mm.",
        counted(static_cast<int>(in_use.size()), "node"), number_text(rms),
        number_text(map.largest));
    if (const int count = left_out_count(result); count > 0) {
        figure.caption += fmt::format(
            " Not among them, marked in orange: {} left out for gross errors, up to "
            "{} mm away.",
            counted(count, "target"), number_text(farthest_left_out));
    }
    figure.caption += thinning_note(result.net);
    return figure;
}

Figure residual_histogram_figure(const IdentificationResult& result) {
    Figure figure{.heading = "Standardised residuals of the survey"};
    const std::vector<double> values = standardised(result);
    if (values.empty()) {
        return figure;
    }
    // Wide enough for the normal law; what lies far outside is counted in the last bins.
    constexpr double reach = 5.0;
    constexpr int bins = 40;
    const std::vector<double> counts = histogram(values, reach, bins);
    const auto total = static_cast<double>(values.size());
    const double highest =
        1.08 * std::max(std::ranges::max(counts), 0.4 * total * 2.0 * reach / bins);
    constexpr double height = 320.0;
    Axes axes;
    axes.y = {.low = 0.0, .high = highest, .from = height - bottom_margin, .to = 28.0};
    axes.y_ticks = nice_ticks(0.0, highest, 5, 1.0);
    axes.x = {
        .low = -reach, .high = reach, .from = left_margin(axes.y_ticks), .to = half_width - 12.0};
    axes.x_ticks = nice_ticks(-reach, reach, 10, 1.0);
    axes.x_label = "residual / its standard deviation";
    axes.y_label = "coordinates";
    SvgBody svg;
    draw_axes(svg, axes, true);
    draw_legend(svg, {axes.x.from, 16.0},
                {{.style = "bar", .words = "survey", .mark = Mark::square},
                 {.style = "std", .words = "normal law", .mark = Mark::dash}});
    for (int i = 0; i < bins; ++i) {
        const Eigen::Vector2d top = axes(-reach + 2.0 * reach * i / bins, counts[i]);
        svg.rectangle("bar", top, {(axes.x.to - axes.x.from) / bins - 0.8, axes.y.from - top.y()});
    }
    svg.path("std", normal_curve(axes, total, 2.0 * reach / bins));
    const auto beyond = std::ranges::count_if(values, [](double v) { return std::abs(v) > 3.0; });
    figure.drawings = {{.name = "residual_histogram",
                        .title = "Histogram of the standardised residuals",
                        .width = half_width,
                        .height = height,
                        .body = svg.take()}};
    figure.caption = fmt::format(
        "Surveyed less predicted coordinate over the stated standard deviation of the survey, for "
        "{}. A fit follows part of the noise: where survey and net are as assumed, the bars stand "
        "somewhat inside the normal law. {} beyond three standard deviations. What lies beyond ±5 "
        "is counted in the last bins.",
        counted(static_cast<int>(values.size()), "coordinate"),
        beyond == 1 ? "1 lies" : fmt::format("{} lie", beyond));
    if (const int count = left_out_count(result); count > 0) {
        figure.caption +=
            fmt::format(" Not among them: {} left out for gross errors.", counted(count, "target"));
    }
    return figure;
}

}  // namespace taut::report
