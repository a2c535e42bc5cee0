// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/tables.hpp"

#include <fmt/core.h>

#include "report/markup.hpp"
#include "report/number_text.hpp"
#include "taut/study/paper_figures.hpp"

namespace taut::report {
namespace {

constexpr std::string_view none = "–";

std::string in_scroll(std::string_view head, const std::string& rows) {
    return fmt::format("<div class=\"scroll\"><table>\n{}<tbody>\n{}</tbody></table></div>\n", head,
                       rows);
}

std::string length_error_row(std::string_view what, std::string_view paper, const std::string& here,
                             std::string_view unit) {
    return fmt::format(
        "<tr><th scope=\"row\">{} [{}]</th><td>{}</td><td class=\"here\">{}</td></tr>\n", what,
        unit, paper, here);
}

std::string form_error_row(std::string_view what, const PaperFigures& paper, const Study& study,
                           double FormErrorSummary::* number) {
    const auto cells = [&](FormErrorSummary FormErrors::* of) {
        return fmt::format(R"(<td class="next">{}</td><td class="here">{}</td><td>{}</td>)",
                           short_number(1e3 * (paper.form_errors.*of.*number)),
                           millimetres(study.form_errors.*of.*number),
                           millimetres(study.mean_form_errors.*of.*number));
    };
    return fmt::format("<tr><th scope=\"row\">{}</th>{}{}</tr>\n", what,
                       cells(&FormErrors::nominal), cells(&FormErrors::identified));
}

std::string row(std::string_view name, std::string_view value) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", name, value);
}

}  // namespace

std::string length_error_table(const Study& study) {
    const PaperFigures paper;
    const LengthErrors& errors = study.gp_as_in_paper.errors;
    return in_scroll(
        R"(<thead><tr><th class="what">Error of the identified lengths</th>
<th scope="col">paper</th><th class="here" scope="col">here</th></tr></thead>
)",
        length_error_row("mean squared error, MSE", short_number(paper.mse),
                         number_text(errors.mse), "m²") +
            length_error_row("mean relative squared error, MRSE", short_number(1e2 * paper.mrse),
                             percent(errors.mrse), "%") +
            length_error_row("largest mean error of an edge", none,
                             millimetres(errors.mean_max_abs()), "mm") +
            length_error_row("standard deviation, mean of the edges", none,
                             millimetres(errors.std_mean()), "mm") +
            length_error_row("true lengths inside their 95 % interval", none,
                             percent(study.gp_as_in_paper.coverage), "%"));
}

std::string form_error_table(const Study& study) {
    const PaperFigures paper;
    return in_scroll(
        R"(<thead><tr><th class="what" rowspan="2">Form error [mm]</th>
<th class="next" colspan="3">nominal</th><th class="next" colspan="3">identified</th></tr>
<tr><th class="next" scope="col">paper</th><th class="here" scope="col">here</th>
<th scope="col">here, mean</th><th class="next" scope="col">paper</th>
<th class="here" scope="col">here</th><th scope="col">here, mean</th></tr></thead>
)",
        form_error_row("max", paper, study, &FormErrorSummary::max) +
            form_error_row("min", paper, study, &FormErrorSummary::min) +
            form_error_row("mean", paper, study, &FormErrorSummary::mean) +
            form_error_row("RMSE", paper, study, &FormErrorSummary::rmse));
}

std::string seconds_table(const Study& study) {
    const auto seconds = [](double value) { return number_text(value) + " s"; };
    return in_scroll("", row("sampling", seconds(study.seconds.sampling)) +
                             row("training", seconds(study.seconds.training)) +
                             row("identification", seconds(study.seconds.identification)) +
                             row("in all", seconds(study.seconds.total)));
}

std::string settings_table(const Study& study, std::string_view version, std::string_view date) {
    const auto number = [](auto value) { return fmt::format("{}", value); };
    return in_scroll(
        "", row("law of the length deviations", study.settings.law.to_string()) +
                row("seed", number(study.settings.seed)) +
                row("samples drawn", number(study.data.size())) +
                row("of these trained on", number(study.model.training_count())) +
                row("of these validated on", number(study.validation.size())) +
                row("with slack edges", number(study.data.with_slack())) +
                row("not converged", number(study.data.not_converged())) +
                row("identified forms not converged", number(study.forms_not_converged)) +
                row("net fingerprint", study.net.fingerprint()) + row("taut", escape(version)) +
                row("date", escape(date)));
}

}  // namespace taut::report
