// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/node_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "report/chart.hpp"
#include "report/colour_bar.hpp"
#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/thinning.hpp"

namespace taut::report {
namespace {

constexpr double title_height = 28.0;

/// Width of the dots: two neighbours nearly touch.
double dot_width(const CableNet& net, const Places& places) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (places.col(s) - places.col(t)).norm();
    }
    return std::clamp(0.82 * sum / net.edge_count(), 1.5, 16.0);
}

void draw_values(SvgBody& svg, const NodeMap& map, const Places& places, double width,
                 const ColourBar& colours) {
    svg.path("outline", dots_path(map.nodes, places),
             fmt::format("style=\"stroke-width:{:.1f}\"", width + 1.0));
    std::map<int, PathData> paths;
    for (const int i : thinned(static_cast<int>(map.nodes.size()), most_drawn)) {
        const int node = map.nodes[i];
        paths[colours.level_of(map.values(i))].dot(places.col(node));
    }
    for (const auto& [level, path] : paths) {
        svg.path("level", path,
                 fmt::format("style=\"stroke:{};stroke-width:{:.1f}\"", ColourBar::colour_of(level),
                             width));
    }
}

}  // namespace

Drawing node_map_drawing(const CableNet& net, const Points& form, const NodeMap& map) {
    const Plan plan = plan_of(form);
    const ColourBar colours(map.largest);
    const Axes axes =
        plan_axes(plan, form, {0.0, title_height}, {half_width - colours.room(), most_height});
    const Places places = places_in(axes, plan, form);
    SvgBody svg;
    svg.text({axes.x.from, 16.0}, map.heading);
    draw_axes(svg, axes, false);
    std::vector<int> edges = net.interior_edges();
    const std::vector<int>& adjustable = net.adjustable_edges();
    edges.insert(edges.end(), adjustable.begin(), adjustable.end());
    svg.path("faint", edges_path(net, edges, places));
    const double width = dot_width(net, places);
    draw_values(svg, map, places, width, colours);
    if (!map.marked.empty()) {
        svg.path("marked", dots_path(map.marked, places),
                 fmt::format("style=\"stroke-width:{:.1f}\"", width));
    }
    colours.draw(svg, {axes.x.to, axes.y.to}, axes.y.from - axes.y.to);
    return {.name = map.name,
            .title = map.title,
            .width = half_width,
            .height = axes.y.from + bottom_margin,
            .body = svg.take(),
            .attributes = node_chart(axes, plan)};
}

}  // namespace taut::report
