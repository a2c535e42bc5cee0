// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/chart.hpp"
#include "report/edge_axes.hpp"
#include "report/figures.hpp"
#include "report/number_text.hpp"
#include "report/thinning.hpp"

namespace taut::report {
namespace {

struct Kind {
    EdgeStatus status;
    const char* style;
};
constexpr std::array kinds{Kind{EdgeStatus::identified, "predicted"},
                           Kind{EdgeStatus::slack, "slack"},
                           Kind{EdgeStatus::unobserved, "unobserved"}};

bool is_slack(const IdentifiedEdge& edge) {
    return edge.status == EdgeStatus::slack;
}

/// The edges of a status: their intervals, with a dot at the estimate. Of a slack edge only
/// the lower bound is known: the dot is there.
void draw_intervals(SvgBody& svg, const Axes& axes, const IdentificationResult& result,
                    const std::vector<int>& edges, const Kind& kind) {
    PathData intervals;
    PathData dots;
    for (const int i : edges) {
        const IdentifiedEdge& edge = result.edges[i];
        if (edge.status == kind.status) {
            intervals.move_to(axes(i + 1, 1e3 * edge.lower));
            intervals.line_to(axes(i + 1, 1e3 * edge.upper));
            dots.dot(axes(i + 1, 1e3 * (is_slack(edge) ? edge.lower : edge.length_deviation)));
        }
    }
    const double width = std::clamp(80.0 / std::sqrt(static_cast<double>(edges.size())), 2.6, 5.0) *
                         (kind.status == EdgeStatus::identified ? 1.0 : 1.7);
    svg.path("link", intervals);
    svg.path(kind.style, dots, fmt::format("style=\"stroke-width:{:.1f}\"", width));
}

std::string caption(const IdentificationResult& result) {
    const auto count = static_cast<int>(result.edges.size());
    const auto slack = static_cast<int>(std::ranges::count_if(result.edges, is_slack));
    std::string text;
    if (slack < count) {
        double widest = 0.0;
        for (const IdentifiedEdge& edge : result.edges) {
            widest = std::max(widest, is_slack(edge) ? 0.0 : edge.upper - edge.lower);
        }
        text = fmt::format(
            "Identified length less nominal length of {}{}, with the interval that holds the true "
            "deviation with 95 % probability; the widest goes {} mm to both sides.",
            counted(count - slack, "interior edge"), slack > 0 ? " in tension" : "",
            millimetres(0.5 * widest));
    }
    if (slack > 0) {
        text += fmt::format("{}Of {} only a lower bound is known, marked by a dot.",
                            text.empty() ? "" : " ", counted(slack, "slack edge"));
    }
    if (const std::string drawn = thinning_words(count, most_edges, "edge"); !drawn.empty()) {
        text += fmt::format(" So that the page stays small, only {} are drawn.", drawn);
    }
    return text;
}

}  // namespace

Figure length_interval_figure(const IdentificationResult& result) {
    const auto count = static_cast<int>(result.edges.size());
    double reach = 0.0;
    for (const IdentifiedEdge& edge : result.edges) {
        reach = std::max(
            {reach, std::abs(edge.lower), std::abs(edge.upper), std::abs(edge.length_deviation)});
    }
    const std::vector<int> edges = thinned(count, most_edges);
    const Axes axes = edge_axes(count, 1e3 * reach, "length deviation [mm]");
    SvgBody svg;
    draw_axes(svg, axes, true);
    std::vector<LegendEntry> legend{
        {.style = "link", .words = "95 % interval", .mark = Mark::dash}};
    for (const Kind& kind : kinds) {
        if (std::ranges::count(result.edges, kind.status, &IdentifiedEdge::status) > 0) {
            legend.push_back({.style = kind.style,
                              .words = kind.status == EdgeStatus::slack
                                           ? "slack: at least"
                                           : std::string(to_string(kind.status))});
        }
    }
    draw_legend(svg, {axes.x.from, edge_legend_y}, legend);
    for (const Kind& kind : kinds) {
        draw_intervals(svg, axes, result, edges, kind);
    }
    return {.drawings = {{.name = "length_intervals",
                          .title = "Length deviations of the interior edges with their intervals",
                          .width = full_width,
                          .height = edge_drawing_height,
                          .body = svg.take(),
                          .attributes = edge_chart(axes)}},
            .heading = "Length deviations with their intervals",
            .caption = caption(result)};
}

}  // namespace taut::report
