// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "files/message.hpp"
#include "interchange/surveys/survey_format_names.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/table_lines.hpp"
#include "interchange/surveys/text_encoding.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// What begins with these bytes is no survey.
constexpr std::pair<std::string_view, std::string_view> no_surveys[] = {
    {"PK\x03\x04", "a ZIP archive, as spreadsheets (xlsx, ods) are: save the table as CSV"},
    {"\xD0\xCF\x11\xE0", "an old Office file: save the table as CSV"},
    {"\x89HDF", "an HDF5 file"},
    {"%PDF", "a PDF file"},
    {"AutoCAD Binary DXF", "a binary DXF file: save it as text (ASCII)"},
    {"LASF", "a LAS point cloud: save its targets as PTS or XYZ"},
    {"\x1F\x8B", "compressed by gzip: unpack it"},
};

constexpr std::string_view readable =
    "expected a survey: table, XYZ, PTS, GSI, LandXML, JobXML, Gama XML or DXF";

/// The first lines that hold something, without comments.
std::vector<std::string_view> first_lines(std::string_view text, size_t count) {
    std::vector<std::string_view> found;
    while (!text.empty() && found.size() < count) {
        const size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        if (!line.empty() && !is_comment(line)) {
            found.push_back(line);
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return found;
}

bool is_gsi_line(std::string_view line) {
    line.remove_prefix(line.starts_with('*') ? 1 : 0);
    const auto is_place = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '?'; };
    return line.size() > 7 && (line.starts_with("11") || line.starts_with("41")) &&
           std::ranges::all_of(line.substr(2, 4), is_place) && (line[6] == '+' || line[6] == '-');
}

bool is_pts_start(const std::vector<std::string_view>& lines) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    return lines.size() > 1 && std::ranges::all_of(lines[0], is_digit) &&
           count_numbers(split_fields({.text = lines[1]}, ' ', "")) >= 3;
}

/// The name of the first element, without its namespace: "LandXML".
std::string_view root_element(std::string_view text) {
    for (size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        std::string_view rest = text.substr(at + 1);
        if (rest.starts_with("!--")) {
            at = std::min(text.find("-->", at), text.size() - 1);
        } else if (rest.starts_with('?') || rest.starts_with('!')) {
            ++at;
        } else {
            rest = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
            const size_t colon = rest.find(':');
            return colon == std::string_view::npos ? rest : rest.substr(colon + 1);
        }
    }
    return {};
}

SurveyFormat xml_format(std::string_view text, const std::string& file_name) {
    const std::string_view root = root_element(text);
    if (root == "LandXML") {
        return SurveyFormat::landxml;
    }
    if (root == "JOBFile") {
        return SurveyFormat::jobxml;
    }
    if (root == "gama-local-adjustment") {
        return SurveyFormat::gama;
    }
    if (root == "gama-local" || root == "gama-xml") {
        throw InputError(file_name, "",
                         "is the input of GNU Gama, expected its adjusted coordinates as XML: run "
                         "gama-local first");
    }
    throw InputError(file_name, "",
                     fmt::format("is XML of the element {}, expected LandXML, JOBFile or "
                                 "gama-local-adjustment",
                                 quote(root)));
}

/// The format by the content; a table where it shows no other.
SurveyFormat format_of_content(std::string_view text, const std::string& file_name) {
    constexpr size_t looked_at = 2;
    const std::vector<std::string_view> lines = first_lines(text, looked_at);
    if (lines.empty()) {
        return SurveyFormat::table;
    }
    if (lines[0].starts_with('<')) {
        return xml_format(text, file_name);
    }
    if (lines[0].starts_with('{') || lines[0].starts_with("[{")) {
        throw InputError(file_name, "", fmt::format("is JSON, {}", readable));
    }
    if (is_pts_start(lines)) {
        return SurveyFormat::pts;
    }
    if (lines.size() > 1 && ((lines[0] == "0" && lines[1] == "SECTION") || lines[0] == "999")) {
        return SurveyFormat::dxf;
    }
    if (is_gsi_line(lines[0])) {
        return SurveyFormat::gsi;
    }
    return SurveyFormat::table;
}

/// What the end of a file's name says, where it says one thing.
std::optional<SurveyFormat> format_of_name(const std::string& file_name) {
    const std::string extension =
        in_lower_case(std::filesystem::path(file_name).extension().string());
    constexpr std::pair<std::string_view, SurveyFormat> known[] = {
        {".csv", SurveyFormat::table}, {".xyz", SurveyFormat::xyz},    {".pts", SurveyFormat::pts},
        {".gsi", SurveyFormat::gsi},   {".jxl", SurveyFormat::jobxml}, {".dxf", SurveyFormat::dxf}};
    const auto* const found =
        std::ranges::find(known, extension, &std::pair<std::string_view, SurveyFormat>::first);
    return found == std::end(known) ? std::nullopt : std::optional(found->second);
}

}  // namespace

SurveyFormat detect_survey_format(std::string_view bytes, const std::string& file_name) {
    for (const auto& [start, what] : no_surveys) {
        if (bytes.starts_with(start)) {
            throw InputError(file_name, "", fmt::format("is {}; {}", what, readable));
        }
    }
    const DecodedText decoded = decode_text(bytes, file_name, std::nullopt);
    const SurveyFormat content = format_of_content(decoded.text, file_name);
    const auto name = format_of_name(file_name);
    // Both are lines of numbers: only the name shows that the points have no names.
    if (name == SurveyFormat::xyz && content == SurveyFormat::table) {
        return SurveyFormat::xyz;
    }
    // A PTS file without its first line is refused as such.
    if (name == SurveyFormat::pts && content == SurveyFormat::table) {
        return SurveyFormat::pts;
    }
    if (name && *name != content) {
        throw InputError(
            file_name, "",
            fmt::format("is {}, expected {} by the end of its name: give the format {} "
                        "to read it as what it is",
                        words_of(content), words_of(*name), to_string(content)));
    }
    return content;
}

}  // namespace taut
