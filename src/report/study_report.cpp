// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/report/study_report.hpp"

#include <fmt/core.h>

#include "report/figure_style.hpp"
#include "report/figures.hpp"
#include "report/markup.hpp"
#include "report/number_text.hpp"
#include "report/page_style.hpp"
#include "report/tables.hpp"
#include "taut/study/paper_figures.hpp"

namespace taut {
namespace report {
namespace {

std::string law_in_words(const LengthLaw& law) {
    const std::string scale = short_number(1e3 * law.scale);
    switch (law.kind) {
        case LengthLaw::Kind::uniform:
            return fmt::format("uniformly within ±{} mm", scale);
        case LengthLaw::Kind::normal:
            return fmt::format("from a normal law with a standard deviation of {} mm", scale);
        case LengthLaw::Kind::bimodal:
            break;
    }
    return fmt::format("close to −{0} mm or to +{0} mm", scale);
}

std::string net_sentence(const CableNet& net) {
    return fmt::format(
        "The net {}has {}, {}, {} of uncertain unstressed length and {} of known length.",
        net.name().empty() ? "" : "“" + net.name() + "” ",
        counted(net.free_node_count(), "free node"),
        counted(static_cast<int>(net.supports().size()), "support"),
        counted(net.interior_edge_count(), "interior edge"),
        counted(static_cast<int>(net.adjustable_edges().size()), "adjustable edge"));
}

std::string sample_sentence(const Study& study) {
    return fmt::format(
        "Length deviations of its interior edges were drawn {}, {} in all; Gaussian processes "
        "learnt on {} of these to tell the lengths from the form, and were tried on {}.",
        law_in_words(study.settings.law), counted(study.data.size(), "sample"),
        study.model.training_count(), counted(static_cast<int>(study.validation.size()), "other"));
}

std::string outcome_sentence(const Study& study) {
    const LengthErrors& errors = study.gp_as_in_paper.errors;
    return fmt::format(
        "The lengths were identified with a mean squared error of {} m² ({} % relative), which "
        "takes the mean form error of the first validation sample from {} mm with nominal lengths "
        "to {} mm with identified ones.",
        number_text(errors.mse), percent(errors.mrse), millimetres(study.form_errors.nominal.mean),
        millimetres(study.form_errors.identified.mean));
}

std::string table_notes(const Study& study) {
    const PaperFigures paper;
    std::string notes =
        "here: the first validation sample, as in the paper; here, mean: each figure's mean over "
        "all validation samples.";
    if (study.net.free_node_count() != paper.free_nodes ||
        study.net.interior_edge_count() != paper.interior_edges) {
        notes += fmt::format(
            " The paper's net is another one: it has {} free nodes and {} interior edges.",
            paper.free_nodes, paper.interior_edges);
    } else {
        notes +=
            " The net has the paper's counts of free nodes and interior edges, not its "
            "geometry, which was not published.";
    }
    return notes;
}

std::string html(const Figure& figure) {
    std::string drawings;
    for (const Drawing& drawing : figure.drawings) {
        drawings +=
            fmt::format("<div{}>{}</div>\n", drawing.width == full_width ? " class=\"wide\"" : "",
                        inline_svg(drawing));
    }
    return fmt::format(
        "<figure>\n<h2>{}</h2>\n<div class=\"drawings\">\n{}</div>\n<figcaption>{}</figcaption>\n"
        "</figure>\n",
        escape(figure.heading), drawings, escape(figure.caption));
}

std::string style() {
    return fmt::format("{}{}@media screen and (prefers-color-scheme:dark){{\n{}{}}}\n", page_style,
                       figure_style(), dark_page_style, dark_figure_style());
}

}  // namespace
}  // namespace report

std::string study_report_html(const Study& study, std::string_view version, std::string_view date) {
    using namespace report;
    const std::string name = study.net.name().empty() ? "A net" : study.net.name();
    std::string figures;
    for (const Figure& figure : study_figures(study)) {
        figures += html(figure);
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>{title}: identified unstressed lengths</title>\n<style>{style}</style>\n</head>\n"
        "<body>\n<h1>{title}: unstressed lengths identified from the form</h1>\n"
        "<p>{net}</p>\n<p>{samples}</p>\n<p>{outcome}</p>\n"
        "<section class=\"together\">\n<h2>Results beside those of the paper</h2>\n{lengths}"
        "{forms}<p class=\"quiet\">{notes}</p>\n</section>\n"
        "{figures}"
        "<div class=\"columns\">\n"
        "<section class=\"together\">\n<h2>Settings and samples</h2>\n{settings}</section>\n"
        "<section class=\"together\">\n<h2>Time</h2>\n{seconds}</section>\n</div>\n"
        "</body>\n</html>\n",
        fmt::arg("title", escape(name)), fmt::arg("style", style()),
        fmt::arg("net", escape(net_sentence(study.net))),
        fmt::arg("samples", escape(sample_sentence(study))),
        fmt::arg("outcome", escape(outcome_sentence(study))),
        fmt::arg("lengths", length_error_table(study)), fmt::arg("forms", form_error_table(study)),
        fmt::arg("notes", escape(table_notes(study))), fmt::arg("figures", figures),
        fmt::arg("seconds", seconds_table(study)),
        fmt::arg("settings", settings_table(study, version, date)));
}

}  // namespace taut
