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

PathData dots(const Axes& axes, const Eigen::VectorXd& values_mm, const std::vector<int>& edges) {
    PathData path;
    for (const int i : edges) {
        path.dot(axes(i + 1, values_mm(i)));
    }
    return path;
}

/// From the true to the identified value of each edge.
PathData links(const Axes& axes, const Eigen::VectorXd& truth_mm,
               const Eigen::VectorXd& estimate_mm, const std::vector<int>& edges) {
    PathData path;
    for (const int i : edges) {
        path.move_to(axes(i + 1, truth_mm(i)));
        path.line_to(axes(i + 1, estimate_mm(i)));
    }
    return path;
}

}  // namespace

Figure length_deviation_figure(const StudyResult& study) {
    const Eigen::VectorXd truth = 1e3 * study.true_deviation;
    const Eigen::VectorXd estimate = 1e3 * study.identified_deviation;
    const Eigen::VectorXd error = truth - estimate;
    const double largest_error = error.cwiseAbs().maxCoeff();
    const double reach =
        std::max({truth.cwiseAbs().maxCoeff(), estimate.cwiseAbs().maxCoeff(), largest_error});

    const auto count = static_cast<int>(truth.size());
    const std::vector<int> edges = thinned(count, most_edges);
    const Axes axes = edge_axes(count, reach, "length deviation [mm]");
    // Few dots may be larger than the style has them.
    const double larger = std::clamp(std::sqrt(300.0 / count), 1.0, 1.8);
    const auto dot_width = [larger](double width) {
        return fmt::format("style=\"stroke-width:{:.1f}\"", larger * width);
    };
    SvgBody svg;
    draw_axes(svg, axes, true);
    draw_legend(svg, {axes.x.from, edge_legend_y},
                {{.style = "true", .words = "true"},
                 {.style = "predicted", .words = "identified"},
                 {.style = "error", .words = "error: true minus identified"}});
    svg.path("link", links(axes, truth, estimate, edges));
    svg.path("true", dots(axes, truth, edges), dot_width(5.4));
    svg.path("predicted", dots(axes, estimate, edges), dot_width(2.4));
    svg.path("error", dots(axes, error, edges), dot_width(2.6));

    std::string caption = fmt::format(
        "True and identified length deviation of {} for the first validation sample, and the error "
        "between them: at most {} mm.",
        count == 1 ? "the interior edge" : fmt::format("the {} interior edges", count),
        number_text(largest_error));
    if (count > most_edges) {
        caption += fmt::format(" So that the page stays small, only {} are drawn.",
                               thinning_words(count, most_edges, "edge"));
    }
    return {.drawings = {{.name = "length_deviations",
                          .title = "True and identified length deviations of the interior edges",
                          .width = full_width,
                          .height = edge_drawing_height,
                          .body = svg.take(),
                          .attributes = edge_chart(axes)}},
            .heading = "Length deviations: true, identified, error",
            .caption = std::move(caption)};
}

}  // namespace taut::report
