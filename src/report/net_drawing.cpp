// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/net_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "report/thinning.hpp"

namespace taut::report {

Axes plan_axes(const Plan& plan, const Points& form, const Eigen::Vector2d& top_left,
               const Eigen::Vector2d& size) {
    const Places points = plan.projection * form;
    const Eigen::Vector2d low = points.rowwise().minCoeff();
    const Eigen::Vector2d high = points.rowwise().maxCoeff();
    // A border of 4 %; a net that is flat in one direction still gets a strip to stand in.
    const double border = 0.04 * (high - low).maxCoeff();
    const Eigen::Vector2d range = (high - low).array() + 2.0 * border;

    Axes axes;
    axes.x = {.low = low.x() - border, .high = high.x() + border};
    axes.y = {.low = low.y() - border, .high = high.y() + border};
    axes.y_ticks = nice_ticks(axes.y.low, axes.y.high, 5);
    const double left = top_left.x() + left_margin(axes.y_ticks);
    const double width = top_left.x() + size.x() - left;
    const double height = size.y() - bottom_margin;
    const double scale = std::min(width / range.x(), height / range.y());
    axes.x.from = left;
    axes.x.to = left + scale * range.x();
    axes.y.to = top_left.y();
    axes.y.from = top_left.y() + scale * range.y();
    // As many marks as labels of 40 units have room.
    axes.x_ticks = nice_ticks(axes.x.low, axes.x.high,
                              std::clamp(static_cast<int>(scale * range.x() / 60.0), 1, 6));
    axes.x_label = plan.right + " [m]";
    axes.y_label = plan.up + " [m]";
    return axes;
}

Places places_in(const Axes& axes, const Plan& plan, const Points& form) {
    Places places = plan.projection * form;
    for (auto place : places.colwise()) {
        place = axes(place.x(), place.y());
    }
    return places;
}

PathData edges_path(const CableNet& net, const std::vector<int>& edges, const Places& places) {
    PathData path;
    for (const int i : thinned(static_cast<int>(edges.size()), most_drawn)) {
        const int edge = edges[i];
        const auto [s, t] = net.edges()[edge];
        path.move_to(places.col(s));
        path.line_to(places.col(t));
    }
    return path;
}

PathData dots_path(const std::vector<int>& nodes, const Places& places) {
    PathData path;
    for (const int i : thinned(static_cast<int>(nodes.size()), most_drawn)) {
        path.dot(places.col(nodes[i]));
    }
    return path;
}

PathData squares_path(const std::vector<int>& nodes, const Places& places, double width) {
    PathData path;
    for (const int i : thinned(static_cast<int>(nodes.size()), most_drawn)) {
        path.square(places.col(nodes[i]), width);
    }
    return path;
}

std::string thinning_note(const CableNet& net) {
    const std::string edges =
        thinning_words(net.interior_edge_count(), most_drawn, "interior edge");
    const std::string nodes = thinning_words(net.free_node_count(), most_drawn, "free node");
    if (edges.empty() && nodes.empty()) {
        return "";
    }
    return fmt::format(" So that the page stays small, only {}{}{} are drawn.", edges,
                       edges.empty() || nodes.empty() ? "" : " and ", nodes);
}

}  // namespace taut::report
