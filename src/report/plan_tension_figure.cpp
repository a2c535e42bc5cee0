// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/chart.hpp"
#include "report/edge_axes.hpp"
#include "report/figures.hpp"
#include "report/number_text.hpp"
#include "report/thinning.hpp"

namespace taut::report {
namespace {

using Tension = PlanResult::Tension;

constexpr double per_kilonewton = 1e-3;  // of a newton

/// By more than what equilibrium is computed to: a plan may rest on its limits.
bool is_beyond(const Tension& tension) {
    constexpr double room = 1.0;  // [N]
    return tension.planned < tension.limit_lower - room ||
           (tension.limit_upper && tension.planned > *tension.limit_upper + room);
}

double most_of(const std::vector<Tension>& tensions) {
    double most = 0.0;
    for (const Tension& tension : tensions) {
        most = std::max({most, tension.as_built, tension.planned, tension.upper.value_or(0.0)});
    }
    return most;
}

/// Upper end of the drawing: limits far above all tensions would press these together.
double top_of(const std::vector<Tension>& tensions) {
    const double most = most_of(tensions);
    double top = most;
    for (const Tension& tension : tensions) {
        if (tension.limit_upper && *tension.limit_upper <= 2.0 * most) {
            top = std::max(top, *tension.limit_upper);
        }
    }
    return top > 0.0 ? 1.05 * per_kilonewton * top : 1.0;
}

/// Some edges, and all that are beyond a limit.
std::vector<int> drawn_edges(const std::vector<Tension>& tensions) {
    std::vector<int> edges = thinned(static_cast<int>(tensions.size()), most_edges);
    for (int e = 0; e < static_cast<int>(tensions.size()); ++e) {
        if (is_beyond(tensions[e])) {
            edges.push_back(e);
        }
    }
    std::ranges::sort(edges);
    // Not std::ranges::unique, which Clang 14 cannot take from GCC's library.
    edges.erase(std::unique(edges.begin(), edges.end()),  // NOLINT(modernize-use-ranges)
                edges.end());
    return edges;
}

/// A line that is level over edges of one limit, and stops where there is none within the drawing.
template <class LimitOf>
PathData limit_path(const Axes& axes, int count, const LimitOf& limit_of) {
    PathData path;
    const auto is_drawn = [&](const std::optional<double>& limit) {
        return limit && per_kilonewton * *limit <= axes.y.high;
    };
    for (int first = 0, last = 0; first < count; first = last) {
        const std::optional<double> limit = limit_of(first);
        while (last < count && limit_of(last) == limit) {
            ++last;
        }
        if (!is_drawn(limit)) {
            continue;
        }
        const Eigen::Vector2d from = axes(first + 0.5, per_kilonewton * *limit);
        first > 0 && is_drawn(limit_of(first - 1)) ? path.line_to(from) : path.move_to(from);
        path.line_to(axes(last + 0.5, per_kilonewton * *limit));
    }
    return path;
}

std::string caption(const std::vector<Tension>& tensions, const std::vector<int>& edges,
                    double top) {
    const auto count = static_cast<int>(tensions.size());
    const auto beyond = static_cast<int>(std::ranges::count_if(tensions, is_beyond));
    const auto high = static_cast<int>(std::ranges::count_if(tensions, [&](const Tension& t) {
        return t.limit_upper && per_kilonewton * *t.limit_upper > top;
    }));
    const bool has_limits = std::ranges::any_of(
        tensions, [](const Tension& t) { return t.limit_lower > 0.0 || t.limit_upper; });
    std::string text = fmt::format(
        "Tension of {} as built and as planned{}; {}. {}", counted(count, "edge"),
        tensions.front().lower ? ", with the 95 % interval over the draws" : "",
        has_limits ? "the lines are the limits that were told"
                   : "no limit was told but that no edge goes slack",
        beyond == 0 ? "None is planned beyond a limit."
                    : fmt::format("{} planned beyond a limit.",
                                  beyond == 1 ? "1 edge is" : fmt::format("{} edges are", beyond)));
    if (high > 0) {
        text += fmt::format(" Upper limits of {} lie above the drawing.", counted(high, "edge"));
    }
    if (edges.size() < tensions.size()) {
        text += fmt::format(" So that the page stays small, only {} of {} edges are drawn.",
                            edges.size(), count);
    }
    return text;
}

}  // namespace

Figure plan_tension_figure(const PlanResult& plan) {
    const std::vector<Tension>& tensions = plan.tensions;
    if (tensions.empty()) {
        return {};
    }
    const std::vector<int> edges = drawn_edges(tensions);
    const Axes axes =
        edge_axes(static_cast<int>(tensions.size()), {.low = 0.0, .high = top_of(tensions)},
                  "edge i, in the order of the net", "tension [kN]");
    PathData intervals;
    PathData built;
    PathData planned;
    PathData beyond;
    for (const int e : edges) {
        const Tension& tension = tensions[e];
        const auto place = [&](double newton) { return axes(e + 1, per_kilonewton * newton); };
        if (tension.lower) {
            intervals.move_to(place(std::max(*tension.lower, 0.0)));
            intervals.line_to(place(*tension.upper));
        }
        built.dot(place(tension.as_built));
        (is_beyond(tension) ? beyond : planned).dot(place(tension.planned));
    }
    // Few dots may be larger than the style has them.
    const double larger =
        std::clamp(std::sqrt(300.0 / static_cast<double>(edges.size())), 0.8, 1.8);
    const auto dot_width = [larger](double width) {
        return fmt::format("style=\"stroke-width:{:.1f}\"", larger * width);
    };
    std::vector<LegendEntry> legend{{.style = "true", .words = "as built"},
                                    {.style = "predicted", .words = "as planned"}};
    if (!beyond.empty()) {
        legend.push_back({.style = "error", .words = "as planned, beyond a limit"});
    }
    if (!intervals.empty()) {
        legend.push_back({.style = "link", .words = "95 % interval", .mark = Mark::dash});
    }
    legend.push_back({.style = "std", .words = "limit", .mark = Mark::dash});
    SvgBody svg;
    draw_axes(svg, axes, true);
    draw_legend(svg, {axes.x.from, edge_legend_y}, legend);
    svg.path("true", built, dot_width(5.0));
    svg.path("link", intervals);
    svg.path("predicted", planned, dot_width(3.4));
    svg.path("error", beyond, dot_width(5.0));
    const auto lower = [&](int e) { return std::optional(tensions[e].limit_lower); };
    const auto upper = [&](int e) { return tensions[e].limit_upper; };
    svg.path("std", limit_path(axes, plan.net.edge_count(), lower));
    svg.path("std", limit_path(axes, plan.net.edge_count(), upper));
    return {.drawings = {{.name = "plan_tensions",
                          .title = "Tensions as built and as planned, with their limits",
                          .width = full_width,
                          .height = edge_drawing_height,
                          .body = svg.take(),
                          .attributes = edge_chart(axes)}},
            .heading = "Tensions and their limits",
            .caption = caption(tensions, edges, axes.y.high)};
}

}  // namespace taut::report
