// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/foreign_survey.hpp"

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

#include "files/message.hpp"
#include "files/plain_text.hpp"
#include "interchange/surveys/survey_format_names.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/text_encoding.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// A survey of targets is some hundred kilobytes; more is a scan of everything, or no survey.
constexpr size_t largest_survey = size_t{64} << 20;

struct FormatNames {
    SurveyFormat format;
    std::string_view name;
    std::string_view words;
};

constexpr FormatNames survey_formats[] = {
    {SurveyFormat::table, "table", "a table of points"},
    {SurveyFormat::xyz, "xyz", "a list of points x y z"},
    {SurveyFormat::pts, "pts", "a PTS file"},
    {SurveyFormat::gsi, "gsi", "a Leica GSI file"},
    {SurveyFormat::landxml, "landxml", "a LandXML file"},
    {SurveyFormat::jobxml, "jobxml", "a Trimble JobXML file"},
    {SurveyFormat::gama, "gama", "an adjustment by GNU Gama"},
    {SurveyFormat::dxf, "dxf", "a DXF file"},
};

/// Whether a format is lines of fields. XML and DXF mark their own end.
bool is_of_lines(SurveyFormat format) {
    return format == SurveyFormat::table || format == SurveyFormat::xyz ||
           format == SurveyFormat::pts || format == SurveyFormat::gsi;
}

ForeignSurvey read_decoded(const std::string& text, const std::string& file_name,
                           SurveyFormat format, const SurveyFileOptions& options) {
    if (is_of_lines(format)) {
        require_last_line_break(text, file_name);
    }
    switch (format) {
        case SurveyFormat::table:
            return read_survey_table(text, file_name, options, false);
        case SurveyFormat::xyz:
            return read_survey_table(text, file_name, options, true);
        case SurveyFormat::pts:
            return read_pts(text, file_name);
        case SurveyFormat::gsi:
            return read_gsi(text, file_name, options);
        case SurveyFormat::landxml:
            return read_landxml(text, file_name);
        case SurveyFormat::jobxml:
            return read_jobxml(text, file_name);
        case SurveyFormat::gama:
            return read_gama(text, file_name);
        case SurveyFormat::dxf:
            return read_dxf(text, file_name);
    }
    throw std::invalid_argument("a format of surveys that is none");
}

}  // namespace

std::string_view to_string(SurveyFormat format) {
    return survey_formats[static_cast<size_t>(format)].name;
}

std::string_view words_of(SurveyFormat format) {
    return survey_formats[static_cast<size_t>(format)].words;
}

SurveyFormat parse_survey_format(std::string_view name) {
    std::string known;
    for (const FormatNames& one : survey_formats) {
        if (one.name == name) {
            return one.format;
        }
        known += (known.empty() ? "" : ", ") + std::string(one.name);
    }
    throw std::invalid_argument(
        fmt::format("there is no format {} of surveys: expected one of {}", quote(name), known));
}

TextEncoding parse_text_encoding(std::string_view name) {
    if (name == "utf-8" || name == "utf-16") {
        return name == "utf-8" ? TextEncoding::utf_8 : TextEncoding::utf_16;
    }
    if (name == "latin-1") {
        return TextEncoding::latin_1;
    }
    throw std::invalid_argument(
        fmt::format("encoding: got '{}', expected 'utf-8', 'utf-16' or 'latin-1'", name));
}

char parse_separator(std::string_view name) {
    constexpr std::pair<std::string_view, char> separators[] = {
        {"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"blank", ' '}};
    for (const auto& [known, sign] : separators) {
        if (known == name) {
            return sign;
        }
    }
    throw std::invalid_argument(
        fmt::format("separator: got '{}', expected 'comma', 'semicolon', 'tab' or 'blank'", name));
}

char parse_decimal_sign(std::string_view name) {
    if (name == "point" || name == "comma") {
        return name == "point" ? '.' : ',';
    }
    throw std::invalid_argument(
        fmt::format("decimal: got '{}', expected 'point' or 'comma'", name));
}

std::string_view to_string(TextEncoding encoding) {
    constexpr std::string_view names[] = {"UTF-8", "UTF-16", "Latin-1"};
    return names[static_cast<size_t>(encoding)];
}

ForeignSurvey read_foreign_survey(std::string_view bytes, const std::string& file_name,
                                  const SurveyFileOptions& options) {
    if (bytes.size() > largest_survey) {
        throw InputError(file_name, "",
                         fmt::format("holds {} MiB, expected a survey of targets, {} MiB at most",
                                     bytes.size() >> 20, largest_survey >> 20));
    }
    const SurveyFormat format =
        options.format ? *options.format : detect_survey_format(bytes, file_name);
    const DecodedText decoded = decode_text(bytes, file_name, options.encoding);
    ForeignSurvey survey = read_decoded(decoded.text, file_name, format, options);
    if (options.takes_observations && survey.polar.observations.empty()) {
        throw InputError(
            file_name, "",
            "holds no observations of angles and distances, for which a precision is given: "
            "expected a Leica GSI file, or a table station,target,hz,v,distance");
    }
    if (survey.points.empty() && survey.polar.observations.empty()) {
        throw InputError(file_name, "",
                         fmt::format("holds no point with three coordinates, expected some as {} "
                                     "has them",
                                     words_of(format)));
    }
    if (decoded.encoding != TextEncoding::utf_8) {
        survey.notes.push_back(fmt::format("encoding: {}", to_string(decoded.encoding)));
    }
    return survey;
}

}  // namespace taut
