// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/number_text.hpp"
#include "report/thinning.hpp"

namespace taut::report {
namespace {

constexpr double title_height = 28.0;
constexpr double most_height = 460.0;
constexpr double bar_width = 12.0;
/// Room of the colour bar with its labels, on the right of the plan.
constexpr double bar_room = 78.0;
/// Colours told apart: dots of one colour share one path.
constexpr int levels = 64;

int level(double value, double largest) {
    return largest > 0.0 ? std::clamp(static_cast<int>(levels * value / largest), 0, levels - 1)
                         : 0;
}

std::string colour(int level) {
    return viridis((level + 0.5) / levels);
}

/// Width of the dots: two neighbours nearly touch.
double dot_width(const CableNet& net, const Places& places) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (places.col(s) - places.col(t)).norm();
    }
    return std::clamp(0.82 * sum / net.edge_count(), 1.5, 16.0);
}

void draw_errors(SvgBody& svg, const CableNet& net, const Places& places,
                 const Eigen::VectorXd& errors_mm, double largest) {
    const double width = dot_width(net, places);
    svg.path("outline", nodes_path(net.free_nodes(), places),
             fmt::format("style=\"stroke-width:{:.1f}\"", width + 1.0));
    std::map<int, PathData> paths;
    const Thinning nodes = thin_to(net.free_node_count(), most_drawn);
    for (int i = 0; i < nodes.count; i += nodes.step) {
        const int node = net.free_nodes()[static_cast<size_t>(i)];
        paths[level(errors_mm(i), largest)].dot(places.col(node));
    }
    for (const auto& [of_level, path] : paths) {
        svg.path("level", path,
                 fmt::format("style=\"stroke:{};stroke-width:{:.1f}\"", colour(of_level), width));
    }
}

void draw_colour_bar(SvgBody& svg, const Eigen::Vector2d& top, double height, double largest) {
    // Two levels a rectangle are enough for the eye.
    const double step = height / (levels / 2);
    for (int i = 0; i < levels; i += 2) {
        const double y = top.y() + height - (i / 2 + 1) * step;
        // Each overlaps the one below a little, or thin lines would show between them.
        const double overlap = i == 0 ? 0.0 : 0.5;
        svg.rectangle("bar", {top.x(), y}, {bar_width, step + overlap},
                      fmt::format("fill=\"{}\"", viridis((i + 1.0) / levels)));
    }
    svg.rectangle("frame", top, {bar_width, height});
    const Scale scale{.low = 0.0, .high = largest, .from = top.y() + height, .to = top.y()};
    const Ticks ticks = nice_ticks(0.0, largest, std::clamp(static_cast<int>(height / 28.0), 2, 8));
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = scale(ticks.values[i]);
        svg.line("frame", {top.x() + bar_width, y}, {top.x() + bar_width + 4.0, y});
        svg.text({top.x() + bar_width + 7.0, y + 4.0}, ticks.labels[i]);
    }
}

Drawing form_error_drawing(const Study& study, const std::string& which,
                           const Eigen::VectorXd& errors_mm) {
    const Points form = nominal_form(study);
    const Plan plan = plan_of(form);
    const Axes axes =
        plan_axes(plan, form, {0.0, title_height}, {half_width - bar_room, most_height});
    const Places places = places_in(axes, plan, form);
    const double largest = errors_mm.maxCoeff();
    SvgBody svg;
    svg.text({axes.x.from, 16.0}, which + " form error [mm]");
    draw_axes(svg, axes, false);
    std::vector<int> edges = study.net.interior_edges();
    const std::vector<int>& adjustable = study.net.adjustable_edges();
    edges.insert(edges.end(), adjustable.begin(), adjustable.end());
    svg.path("faint", edges_path(study.net, edges, places));
    draw_errors(svg, study.net, places, errors_mm, largest);
    draw_colour_bar(svg, {axes.x.to + 14.0, axes.y.to}, axes.y.from - axes.y.to,
                    largest > 0.0 ? largest : 1.0);
    return {.name = "form_error_" + which,
            .title = "The " + which + " form error at the free nodes, in plan",
            .width = half_width,
            .height = axes.y.from + bottom_margin,
            .body = svg.take()};
}

std::string ratio_sentence(const FormErrors& errors) {
    if (!(errors.identified.mean > 0.0)) {
        return "";
    }
    const double ratio = errors.nominal.mean / errors.identified.mean;
    return fmt::format(
        " In the mean of the nodes, identification makes the form error {} times {}.",
        number_text(ratio >= 1.0 ? ratio : 1.0 / ratio), ratio >= 1.0 ? "smaller" : "larger");
}

}  // namespace

Figure form_error_figure(const Study& study) {
    const FormErrors& errors = study.form_errors;
    return {
        .drawings = {form_error_drawing(study, "nominal", 1e3 * study.nominal_form_error),
                     form_error_drawing(study, "identified", 1e3 * study.identified_form_error)},
        .heading = "Form error over the net",
        .caption = fmt::format(
            "Distance of the nominal form (mean {} mm) and of the form with the identified "
            "lengths (mean {} mm) from the true form at the free nodes, for the first "
            "validation sample. Each has its own colour scale.{}{}",
            millimetres(errors.nominal.mean), millimetres(errors.identified.mean),
            ratio_sentence(errors), thinning_note(study.net))};
}

}  // namespace taut::report
