// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

constexpr double legend_height = 26.0;

/// Edges and nodes, each kind in its style.
void draw_net(SvgBody& svg, const CableNet& net, const Places& places) {
    svg.path("interior", edges_path(net, net.interior_edges(), places));
    svg.path("adjustable", edges_path(net, net.adjustable_edges(), places));
    // Dots that would touch hide the edges: they shrink with the number of nodes.
    const double size =
        std::clamp(60.0 / std::sqrt(static_cast<double>(net.node_count())), 0.6, 5.0);
    svg.path("free", dots_path(net.free_nodes(), places),
             fmt::format("style=\"stroke-width:{:.1f}\"", size));
    svg.path("support", squares_path(net.supports(), places, std::max(1.3 * size, 2.0)));
}

/// Three arms of one length along x, y and z, in a corner.
void draw_cross(SvgBody& svg, const Projection& view, const Eigen::Vector2d& middle, double arm) {
    const char* const names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector2d direction(view(0, axis), -view(1, axis));
        const Eigen::Vector2d tip = middle + arm * direction;
        PathData path;
        path.move_to(middle);
        path.line_to(tip);
        svg.path("arm", path);
        svg.text(tip + 9.0 * direction.normalized() + Eigen::Vector2d(0.0, 4.0), names[axis],
                 SvgBody::Anchor::middle);
    }
}

/// The largest of 1, 2 or 5 times a power of ten that is no longer than a tenth of the net [m].
double nice_arm(const Points& form) {
    const double longest = 0.1 * extent(form).maxCoeff();
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    const double times = longest / power;
    return power * (times >= 5.0 ? 5.0 : times >= 2.0 ? 2.0 : 1.0);
}

Drawing slanting_drawing(const CableNet& net, const Points& form, double arm_metres) {
    const Projection view = slanting_view();
    const Places points = view * form;
    const Eigen::Vector2d low = points.rowwise().minCoeff();
    const Eigen::Vector2d size = points.rowwise().maxCoeff() - low;
    constexpr double margin = 14.0;
    constexpr double name_height = 16.0;
    const double scale = std::min((half_width - 2.0 * margin) / size.x(),
                                  (most_height - legend_height) / std::max(size.y(), 1e-9));
    Places places = points;
    for (auto place : places.colwise()) {
        place = Eigen::Vector2d(margin + scale * (place.x() - low.x()),
                                legend_height + margin + scale * (low.y() + size.y() - place.y()));
    }
    SvgBody svg;
    draw_legend(svg, {margin, 16.0},
                {{.style = "free", .words = "free node"},
                 {.style = "support", .words = "support", .mark = Mark::square},
                 {.style = "interior", .words = "interior edge", .mark = Mark::dash},
                 {.style = "adjustable", .words = "adjustable edge", .mark = Mark::dash}});
    draw_net(svg, net, places);
    const double arm = scale * arm_metres;
    const double bottom = legend_height + margin + scale * size.y();
    // Below the net: as far up as the highest of the arms goes, and as far down as the lowest.
    const double middle = bottom + arm * std::max(view.row(1).maxCoeff(), 0.0) + name_height;
    const double height = middle - arm * std::min(view.row(1).minCoeff(), 0.0) + name_height;
    draw_cross(svg, view, {margin + 8.0, middle}, arm);
    return {.name = "net_view",
            .title = "The net, seen slantwise from above",
            .width = half_width,
            .height = height,
            .body = svg.take()};
}

Drawing plan_drawing(const CableNet& net, const Plan& plan, const Points& form) {
    const Axes axes = plan_axes(plan, form, {0.0, legend_height}, {half_width - 10.0, most_height});
    SvgBody svg;
    draw_axes(svg, axes, false);
    draw_net(svg, net, places_in(axes, plan, form));
    return {.name = "net_plan",
            .title = "The net, seen " + plan.seen,
            .width = half_width,
            .height = axes.y.from + bottom_margin,
            .body = svg.take()};
}

}  // namespace

Figure net_figure(const CableNet& net, const Points& form, const std::string& which) {
    const Plan plan = plan_of(form);
    const double arm = nice_arm(form);
    return {.drawings = {slanting_drawing(net, form, arm), plan_drawing(net, plan, form)},
            .heading = "The net",
            .caption = fmt::format(
                "The {} form in parallel projection (the arms of the cross are {} m long) and "
                "seen {}: {}, {}, {} of uncertain unstressed length and {} of known unstressed "
                "length.{}",
                which, short_number(arm), plan.seen, counted(net.free_node_count(), "free node"),
                counted(static_cast<int>(net.supports().size()), "support"),
                counted(net.interior_edge_count(), "interior edge"),
                counted(static_cast<int>(net.adjustable_edges().size()), "adjustable edge"),
                thinning_note(net))};
}

}  // namespace taut::report
