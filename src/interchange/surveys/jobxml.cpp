// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/survey_xml.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// Coordinates of a record, of the first of these elements that holds all three.
std::optional<Eigen::Vector3d> jobxml_place(const SurveyXml& xml, pugi::xml_node record) {
    for (const char* const name : {"Grid", "ComputedGrid"}) {
        const pugi::xml_node grid = record.child(name);
        const auto north = xml.number(grid, "North");
        const auto east = xml.number(grid, "East");
        const auto height = xml.number(grid, "Elevation");
        if (north && east && height) {
            return Eigen::Vector3d(*east, *north, *height);
        }
    }
    return std::nullopt;
}

void add_jobxml_points(const SurveyXml& xml, pugi::xml_node below, std::string_view element,
                       ForeignSurvey& survey) {
    for (const pugi::xml_node record : SurveyXml::elements(below, element)) {
        const std::string name(trimmed(record.child("Name").text().get()));
        const int line = xml.line_of(record);
        const auto leave_out = [&](const char* why) {
            survey.left_out.push_back(
                {.line = line, .reason = fmt::format("point {} {}", quote(name), why)});
        };
        if (std::string_view(record.child("Deleted").text().get()) == "true") {
            leave_out("was deleted");
        } else if (const auto place = jobxml_place(xml, record)) {
            survey.points.push_back({.id = name,
                                     .position = *place,
                                     .line = line,
                                     .code = record.child("Code").text().get()});
        } else {
            leave_out("has no Grid with North, East and Elevation");
        }
    }
}

}  // namespace

ForeignSurvey read_jobxml(const std::string& text, const std::string& file_name) {
    const SurveyXml xml(text, file_name);
    // Lengths in a JobXML file are in metres, whatever its display shows.
    ForeignSurvey survey{.format = "Trimble JobXML", .unit = 1.0};
    const char* from = "Reductions";
    for (const pugi::xml_node reductions : SurveyXml::elements(xml.root(), "Reductions")) {
        add_jobxml_points(xml, reductions, "Point", survey);
    }
    if (survey.points.empty()) {
        from = "PointRecord";
        survey.left_out.clear();
        add_jobxml_points(xml, xml.root(), from, survey);
    }
    if (survey.points.empty() && !survey.left_out.empty()) {
        throw InputError(
            file_name, "",
            fmt::format("holds {} points and no coordinates of any, expected a Grid or "
                        "ComputedGrid with North, East and Elevation: angles and "
                        "distances are to be reduced first",
                        survey.left_out.size()));
    }
    survey.notes.push_back(
        fmt::format("columns: {} by East, North, Elevation as x, y, z; Name as id", from));
    return survey;
}

}  // namespace taut
