// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/survey_xml.hpp"

namespace taut {
namespace {

std::optional<double> landxml_unit(const SurveyXml& xml) {
    for (const pugi::xml_node units : SurveyXml::elements(xml.root(), "Units")) {
        for (const pugi::xml_node system : units.children()) {
            const std::string_view name = system.attribute("linearUnit").value();
            if (name.empty()) {
                continue;
            }
            const auto unit = length_of_unit(name);
            if (!unit) {
                xml.fail(system, fmt::format("has the linearUnit {}, which taut does not know",
                                             quote(name)));
            }
            return unit;
        }
    }
    return std::nullopt;
}

/// The words of a text, between blanks and ends of lines.
std::vector<std::string_view> landxml_words(std::string_view text) {
    std::vector<std::string_view> words;
    constexpr const char* blanks = " \t\r\n";
    while ((text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size())),
            !text.empty())) {
        const size_t end = std::min(text.find_first_of(blanks), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

}  // namespace

ForeignSurvey read_landxml(const std::string& text, const std::string& file_name) {
    const SurveyXml xml(text, file_name);
    ForeignSurvey survey{.format = "LandXML", .unit = landxml_unit(xml)};
    for (const pugi::xml_node node : SurveyXml::elements(xml.root(), "CgPoint")) {
        const auto words = landxml_words(node.text().get());
        const std::string_view name = node.attribute("name").value();
        SurveyPoint point{.id = std::string(name),
                          .line = xml.line_of(node),
                          .code = node.attribute("code").value()};
        constexpr size_t coordinates = 3;
        if (words.size() < coordinates) {
            survey.left_out.push_back(
                {.line = point.line,
                 .reason = fmt::format("CgPoint {} has {} coordinates, not three", quote(name),
                                       words.size())});
            continue;
        }
        if (words.size() > coordinates) {
            xml.fail(node, fmt::format("CgPoint {} has {} numbers, expected northing, easting, "
                                       "elevation",
                                       quote(name), words.size()));
        }
        // In this order, whatever the file calls its axes.
        point.position.y() = xml.number(node, words[0], "northing");
        point.position.x() = xml.number(node, words[1], "easting");
        point.position.z() = xml.number(node, words[2], "elevation");
        survey.points.push_back(std::move(point));
    }
    survey.notes.emplace_back(
        "columns: CgPoint by northing, easting, elevation as y, x, z; name as id");
    return survey;
}

}  // namespace taut
