// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/result_xlsx.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "files/csv_field.hpp"
#include "files/parse_number.hpp"
#include "files/xlsx_writer.hpp"
#include "results/document_parts.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

using nlohmann::json;

constexpr double to_milli = 1e3;
constexpr double to_kilo = 1e-3;

/// A number of the document, or nothing where it is null or not there.
XlsxCell number_cell(const json& object, const char* key, double factor = 1.0) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? XlsxCell(factor * found->get<double>())
                                                       : XlsxCell();
}

std::string text_of_key(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

/// A name, as a number where it is a whole one that spreadsheets show in full: they mark numbers
/// that are text. Others as in a CSV file, which such a sheet is read like.
XlsxCell name_cell(const std::string& id) {
    constexpr double most_digits = 1e15;
    const auto value = parse_number(id);
    if (value && std::abs(*value) < most_digits && fmt::format("{:.0f}", *value) == id &&
        id != "-0") {
        return *value;
    }
    return begins_as_formula(id) && !value ? "'" + id : id;
}

std::vector<std::string> texts_of_key(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() ? found->get<std::vector<std::string>>()
                                 : std::vector<std::string>();
}

XlsxSheet sheet_of_turns(const CableNet& net, const json& plan) {
    XlsxSheet sheet{.name = "turns",
                    .remarks = texts_of_key(plan, "warnings"),
                    .columns = {{"number"},
                                {"crew"},
                                {"pass"},
                                {"step"},
                                {"edge"},
                                {"support"},
                                {"action"},
                                {"rotation"},
                                {"turns", 3},
                                {"stroke_mm", 3},
                                {"scale_reading_mm", 3},
                                {"tension_after_kN", 3},
                                {"frequency_after_step_Hz", 3}},
                    .rows = {}};
    const bool has_tensions = plan.at("draws") > 0;
    for (const json& turn : plan.at("turns")) {
        const int edge = turn.at("edge");
        sheet.rows.push_back(
            {static_cast<double>(sheet.rows.size() + 1), number_cell(turn, "crew"),
             number_cell(turn, "pass"), turn.at("step").get<double>() + 1.0,
             name_cell(net.edge_id(edge)), name_cell(support_id(net, edge)),
             text_of_key(turn, "action"), text_of_key(turn, "rotation"), number_cell(turn, "turns"),
             number_cell(turn, "stroke", to_milli), number_cell(turn, "reading_after", to_milli),
             has_tensions ? number_cell(turn, "tension_after", to_kilo) : XlsxCell(),
             has_tensions ? number_cell(turn, "frequency_after_step") : XlsxCell()});
    }
    return sheet;
}

XlsxSheet sheet_of_edges(const CableNet& net, const json& result) {
    XlsxSheet sheet{.name = "edges",
                    .remarks = {},
                    .columns = {{"edge"},
                                {"from"},
                                {"to"},
                                {"status"},
                                {"nominal_m", 5},
                                {"length_deviation_mm", 3},
                                {"std_mm", 3},
                                {"lower_mm", 3},
                                {"upper_mm", 3},
                                {"tension_kN", 3},
                                {"tension_std_kN", 3},
                                {"tension_lower_kN", 3},
                                {"tension_upper_kN", 3},
                                {"slack_probability", 3}},
                    .rows = {}};
    std::map<int, json> of_edge;
    for (const char* const key : {"edges", "adjustable_edges"}) {
        for (const json& edge : result.value(key, json::array())) {
            of_edge[edge.at("edge")] = edge;
        }
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const json& edge = of_edge[e];
        const bool is_adjustable = net.interior_index(e) < 0;
        const auto [from, to] = net.edges()[static_cast<size_t>(e)];
        sheet.rows.push_back(
            {name_cell(net.edge_id(e)), name_cell(net.node_id(from)), name_cell(net.node_id(to)),
             is_adjustable ? "adjustable" : text_of_key(edge, "status"),
             net.unstressed_lengths()(e), number_cell(edge, "length_deviation", to_milli),
             number_cell(edge, "std", to_milli), number_cell(edge, "lower", to_milli),
             number_cell(edge, "upper", to_milli), number_cell(edge, "tension", to_kilo),
             number_cell(edge, "tension_std", to_kilo), number_cell(edge, "tension_lower", to_kilo),
             number_cell(edge, "tension_upper", to_kilo), number_cell(edge, "slack_probability")});
    }
    return sheet;
}

XlsxSheet sheet_of_nodes(const IdentificationResult& result) {
    XlsxSheet sheet{.name = "nodes",
                    .remarks = {},
                    .columns = {{"node"},
                                {"kind"},
                                {"x_m", 5},
                                {"y_m", 5},
                                {"z_m", 5},
                                {"target"},
                                {"surveyed_less_predicted_x_mm", 3},
                                {"surveyed_less_predicted_y_mm", 3},
                                {"surveyed_less_predicted_z_mm", 3}},
                    .rows = {}};
    for (int n = 0; n < result.net.node_count(); ++n) {
        const Eigen::Vector3d place = result.form.col(n);
        sheet.rows.push_back({name_cell(result.net.node_id(n)),
                              result.net.is_support(n) ? "support" : "free",
                              place.x(),
                              place.y(),
                              place.z(),
                              {},
                              {},
                              {},
                              {}});
    }
    for (const IdentificationResult::Residual& residual : result.residuals) {
        std::vector<XlsxCell>& row = sheet.rows[static_cast<size_t>(residual.node)];
        row[5] = residual.is_in_use ? "used" : "left out";
        for (Eigen::Index k = 0; k < 3; ++k) {
            row[static_cast<size_t>(6 + k)] = to_milli * residual.surveyed_less_predicted(k);
        }
    }
    return sheet;
}

std::vector<std::string> verdict_of(const json& result) {
    const json trust = result.value("trust", json::object());
    const std::string verdict = text_of_key(trust, "verdict");
    return verdict.empty() || verdict == "passed"
               ? std::vector<std::string>()
               : std::vector{fmt::format("Checks: {}: {}", verdict,
                                         fmt::join(texts_of_key(trust, "reasons"), "; "))};
}

}  // namespace

ResultXlsx result_to_xlsx(const ResultFile& result, const std::string& file_name) {
    const json document = json::parse(result.json);
    std::vector<XlsxSheet> sheets;
    if (const auto* const plan = std::get_if<PlanResult>(&result.content)) {
        sheets = {sheet_of_turns(plan->net, document)};
    } else if (const auto* const found = std::get_if<IdentificationResult>(&result.content)) {
        sheets = {sheet_of_edges(found->net, document), sheet_of_nodes(*found)};
        for (XlsxSheet& sheet : sheets) {
            sheet.remarks = verdict_of(document);
        }
    } else {
        throw InputError(file_name, "/format",
                         fmt::format("is '{}', expected the result of identify or plan, which have "
                                     "tables",
                                     text_of_key(document, "format")));
    }
    return {.bytes = xlsx_bytes(sheets), .remarks = sheets.front().remarks};
}

}  // namespace taut
