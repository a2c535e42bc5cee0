// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/node_map.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

std::string ratio_sentence(double nominal, double identified) {
    if (!(identified > 0.0)) {
        return "";
    }
    const double ratio = nominal / identified;
    return fmt::format(
        " In the mean of the nodes, identification makes the form error {} times {}.",
        number_text(ratio >= 1.0 ? ratio : 1.0 / ratio), ratio >= 1.0 ? "smaller" : "larger");
}

}  // namespace

Figure form_error_figure(const StudyResult& study) {
    const Eigen::VectorXd& nominal = study.nominal_form_error;
    const Eigen::VectorXd& identified = study.identified_form_error;
    const double largest = 1e3 * std::max(nominal.maxCoeff(), identified.maxCoeff());
    const auto drawing = [&](const std::string& which, const Eigen::VectorXd& errors) {
        return node_map_drawing(study.net, study.nominal_form,
                                {.name = "form_error_" + which,
                                 .title = "The " + which + " form error at the free nodes, in plan",
                                 .heading = which + " form error [mm]",
                                 .nodes = study.net.free_nodes(),
                                 .values = 1e3 * errors,
                                 .largest = largest});
    };
    return {.drawings = {drawing("nominal", nominal), drawing("identified", identified)},
            .heading = "Form error over the net",
            .caption = fmt::format(
                "Distance of the nominal form (mean {} mm) and of the form with the identified "
                "lengths (mean {} mm) from the true form at the free nodes, for the first "
                "validation sample. Both have the same view and the same colour scale.{}{}",
                millimetres(nominal.mean()), millimetres(identified.mean()),
                ratio_sentence(nominal.mean(), identified.mean()), thinning_note(study.net))};
}

}  // namespace taut::report
