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

/// More dots would make the page large and no clearer; a dot takes some seven bytes.
constexpr int most_dots = 30000;
/// The errors of the edges, as columns of dots. Dots less than half a unit apart fall together.
PathData dots(const Axes& axes, const Eigen::MatrixXd& errors_mm, const std::vector<int>& edges) {
    PathData path;
    if (errors_mm.cols() == 0) {  // the matrix has no memory whose rows could be taken
        return path;
    }
    std::vector<double> column(errors_mm.cols());
    for (const int i : edges) {
        std::ranges::transform(errors_mm.row(i), column.begin(),
                               [&](double error) { return 0.5 * std::round(2.0 * axes.y(error)); });
        std::ranges::sort(column);
        // Not std::ranges::unique, which Clang 14 cannot take from GCC's library.
        column.erase(std::unique(column.begin(), column.end()),  // NOLINT(modernize-use-ranges)
                     column.end());
        for (const double y : column) {
            path.dot({axes.x(i + 1), y});
        }
        column.resize(errors_mm.cols());
    }
    return path;
}

/// Joins the values of neighbouring edges, and goes on a little beyond the first and the last: one
/// edge alone shows as a dash.
PathData curve(const Axes& axes, const Eigen::VectorXd& values_mm, const std::vector<int>& edges) {
    constexpr double beyond = 0.4;
    PathData path;
    path.move_to(axes(edges.front() + 1 - beyond, values_mm(edges.front())));
    for (const int i : edges) {
        path.line_to(axes(i + 1, values_mm(i)));
    }
    path.line_to(axes(edges.back() + 1 + beyond, values_mm(edges.back())));
    return path;
}

std::string caption(const StudyResult& study, int edge_limit) {
    Eigen::Index worst = 0;
    const double largest_mean = study.error_mean.cwiseAbs().maxCoeff(&worst);
    const int edge = study.net.interior_edges()[worst];
    std::string text = fmt::format(
        "Error (true minus identified) of every interior edge in {}, with its mean over them and "
        "one standard deviation to both sides. The largest mean error is {} mm, at edge {} (i = "
        "{}); the "
        "standard deviation is {} mm in the mean of the edges.",
        study.validation == 1 ? "the one validation sample"
                              : fmt::format("all {} validation samples", study.validation),
        millimetres(largest_mean), study.net.edge_id(edge), worst + 1,
        millimetres(study.error_std.mean()));
    const std::string drawn = thinning_words(study.net.interior_edge_count(), edge_limit, "edge");
    if (!drawn.empty()) {
        text += fmt::format(" So that the page stays small, only {} are drawn.", drawn);
    }
    return text;
}

}  // namespace

Figure length_error_figure(const StudyResult& study) {
    const Eigen::MatrixXd errors = 1e3 * study.errors;
    const Eigen::VectorXd mean = 1e3 * study.error_mean;
    const Eigen::VectorXd std = 1e3 * study.error_std;
    double reach = (mean.cwiseAbs() + std).maxCoeff();
    if (errors.size() > 0) {
        reach = std::max(reach, errors.cwiseAbs().maxCoeff());
    }

    const auto count = static_cast<int>(errors.rows());
    const auto samples = static_cast<int>(errors.cols());
    const int edge_limit = std::clamp(most_dots / std::max(samples, 1), 1, most_edges);
    const std::vector<int> edges = thinned(count, edge_limit);
    const Axes axes = edge_axes(count, reach, "error [mm]");
    SvgBody svg;
    draw_axes(svg, axes, true);
    draw_legend(svg, {axes.x.from, edge_legend_y},
                {{.style = "all-errors",
                  .words = "error in one sample",
                  .attributes = "style=\"stroke-width:3;stroke-opacity:1\""},
                 {.style = "mean", .words = "mean", .mark = Mark::dash},
                 {.style = "std", .words = "mean ± standard deviation", .mark = Mark::dash}});
    // Few dots may be larger than the style has them.
    const double dot_width = std::clamp(
        150.0 / std::sqrt(static_cast<double>(edges.size()) * std::max(samples, 1)), 1.5, 5.0);
    svg.path("all-errors", dots(axes, errors, edges),
             fmt::format("style=\"stroke-width:{:.1f}\"", dot_width));
    svg.path("std", curve(axes, mean + std, edges));
    svg.path("std", curve(axes, mean - std, edges));
    svg.path("mean", curve(axes, mean, edges));
    return {.drawings = {{.name = "length_errors",
                          .title = "Errors of the identified lengths over the interior edges",
                          .width = full_width,
                          .height = edge_drawing_height,
                          .body = svg.take(),
                          .attributes = edge_chart(axes)}},
            .heading = "Errors over all validation samples",
            .caption = caption(study, edge_limit)};
}

}  // namespace taut::report
