// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/report/study_figures.hpp"

#include "report/figures.hpp"

namespace taut {
namespace report {

std::vector<Figure> study_figures(const Study& study) {
    return {net_figure(study), length_deviation_figure(study), length_error_figure(study),
            form_error_figure(study)};
}

}  // namespace report

std::vector<std::pair<std::string, std::string>> study_figures_svg(const Study& study) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const report::Figure& figure : report::study_figures(study)) {
        for (const report::Drawing& drawing : figure.drawings) {
            files.emplace_back(drawing.name + ".svg", report::standalone_svg(drawing));
        }
    }
    return files;
}

}  // namespace taut
