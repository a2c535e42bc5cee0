// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "report/colour_bar.hpp"
#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/number_text.hpp"
#include "report/thinning.hpp"

namespace taut::report {
namespace {

constexpr double title_height = 28.0;
constexpr double most_height = 460.0;
/// Width of the dots: two neighbours nearly touch.
double dot_width(const CableNet& net, const Places& places) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (places.col(s) - places.col(t)).norm();
    }
    return std::clamp(0.82 * sum / net.edge_count(), 1.5, 16.0);
}

void draw_errors(SvgBody& svg, const CableNet& net, const Places& places,
                 const Eigen::VectorXd& errors_mm, const ColourBar& colours) {
    const double width = dot_width(net, places);
    svg.path("outline", dots_path(net.free_nodes(), places),
             fmt::format("style=\"stroke-width:{:.1f}\"", width + 1.0));
    std::map<int, PathData> paths;
    for (const int i : thinned(net.free_node_count(), most_drawn)) {
        const int node = net.free_nodes()[static_cast<size_t>(i)];
        paths[colours.level_of(errors_mm(i))].dot(places.col(node));
    }
    for (const auto& [level, path] : paths) {
        svg.path("level", path,
                 fmt::format("style=\"stroke:{};stroke-width:{:.1f}\"", ColourBar::colour_of(level),
                             width));
    }
}

Drawing form_error_drawing(const Study& study, const std::string& which,
                           const Eigen::VectorXd& errors_mm) {
    const Points form = nominal_form(study);
    const Plan plan = plan_of(form);
    const ColourBar colours(errors_mm.maxCoeff());
    const Axes axes =
        plan_axes(plan, form, {0.0, title_height}, {half_width - colours.room(), most_height});
    const Places places = places_in(axes, plan, form);
    SvgBody svg;
    svg.text({axes.x.from, 16.0}, which + " form error [mm]");
    draw_axes(svg, axes, false);
    std::vector<int> edges = study.net.interior_edges();
    const std::vector<int>& adjustable = study.net.adjustable_edges();
    edges.insert(edges.end(), adjustable.begin(), adjustable.end());
    svg.path("faint", edges_path(study.net, edges, places));
    draw_errors(svg, study.net, places, errors_mm, colours);
    colours.draw(svg, {axes.x.to, axes.y.to}, axes.y.from - axes.y.to);
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
