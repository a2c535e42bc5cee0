// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/report/figures_svg.hpp"

#include "report/figures.hpp"

namespace taut {
namespace report {
namespace {

std::vector<Figure> figures(const StudyResult& study) {
    return {net_figure(study.net, study.nominal_form, "nominal"), length_deviation_figure(study),
            length_error_figure(study), form_error_figure(study)};
}

std::vector<Figure> figures(const IdentificationResult& result) {
    return {net_figure(result.net, result.form, "predicted"), length_interval_figure(result),
            residual_map_figure(result), residual_histogram_figure(result)};
}

std::vector<Figure> figures(const ComparisonResult& comparison) {
    return {comparison_figure(comparison)};
}

std::vector<Figure> figures(const PlanResult& plan) {
    return {plan_deviation_figure(plan), plan_tension_figure(plan)};
}

std::vector<Figure> figures(const ControlResult& control) {
    return {control_form_figure(control), control_work_figure(control)};
}

}  // namespace

std::vector<Figure> result_figures(const ResultFile& result) {
    auto all = std::visit([](const auto& content) { return figures(content); }, result.content);
    std::erase_if(all, [](const Figure& figure) { return figure.drawings.empty(); });
    return all;
}

}  // namespace report

std::vector<std::pair<std::string, std::string>> figures_svg(const ResultFile& result) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const report::Figure& figure : report::result_figures(result)) {
        for (const report::Drawing& drawing : figure.drawings) {
            files.emplace_back(drawing.name + ".svg", report::standalone_svg(drawing));
        }
    }
    return files;
}

}  // namespace taut
