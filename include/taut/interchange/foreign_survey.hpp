// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/survey/station_adjustment.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Formats of surveys that instruments and other programs write.
enum class SurveyFormat {
    table,    ///< lines of separated fields, with a header or without
    xyz,      ///< the same, of points without names: x y z and what is behind
    pts,      ///< the number of points, then lines x y z and what is behind
    gsi,      ///< Leica GSI-8 and GSI-16
    landxml,  ///< CgPoints of LandXML
    jobxml,   ///< Trimble JobXML (JXL)
    gama,     ///< adjusted coordinates of GNU Gama
    dxf,      ///< POINT entities, named by the TEXT beside them
};

/// "table", "xyz", "pts", "gsi", "landxml", "jobxml", "gama", "dxf".
[[nodiscard]] TAUT_IO_EXPORT std::string_view to_string(SurveyFormat format);

/// The format that to_string() calls so.
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_IO_EXPORT SurveyFormat parse_survey_format(std::string_view name);

/// How bytes stand for letters.
enum class TextEncoding { utf_8, utf_16, latin_1 };

/// "UTF-8", "UTF-16", "Latin-1".
[[nodiscard]] TAUT_IO_EXPORT std::string_view to_string(TextEncoding encoding);

/// The encoding of "utf-8", "utf-16", "latin-1".
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_IO_EXPORT TextEncoding parse_text_encoding(std::string_view name);

/// The sign of "comma", "semicolon", "tab", "blank".
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_IO_EXPORT char parse_separator(std::string_view name);

/// The sign of "point", "comma".
/// @throws std::invalid_argument for another name
[[nodiscard]] TAUT_IO_EXPORT char parse_decimal_sign(std::string_view name);

/// What is given for a survey file; the rest is found in it.
struct SurveyFileOptions {
    std::optional<SurveyFormat> format;  ///< empty: that of detect_survey_format()
    /// Of a table, in their order: id, x, y, z, sx, sy, sz, code (the kind of target), and - for
    /// one to leave out; empty: as its header says.
    std::vector<std::string> columns;
    std::optional<char> separator;  ///< of a table: comma, semicolon, tab, or blank for blanks
    std::optional<char> decimal;    ///< of a table: '.' or ','
    std::optional<TextEncoding> encoding;  ///< of its text; empty: as its bytes show
    /// Whether to take angles and distances, even where the file has coordinates, too.
    bool takes_observations = false;
    std::optional<double> angle_unit;  ///< of such observations, where the file has none [rad]

    /// All fields.
    [[nodiscard]] bool operator==(const SurveyFileOptions&) const = default;
};

/// Columns of a table out of "id,x,y,z,-,sx,sy,sz".
/// @throws std::invalid_argument for another name, one that comes twice, a coordinate that is not
///   there, and only one or two of sx, sy, sz
[[nodiscard]] TAUT_IO_EXPORT std::vector<std::string> parse_survey_columns(std::string_view text);

/// The length of a unit, "mm", "cm", "m", "in", "ft", "us-ft" [m]; nothing for another name.
[[nodiscard]] TAUT_IO_EXPORT std::optional<double> length_of_unit(std::string_view name);

/// A line, or an element, of a file that is no point.
struct LeftOutLine {
    int line = 0;        ///< in the file, from 1; 0: not of one line
    std::string reason;  ///< what it is, or why it is no point
};

/// What was found in a survey file. Every format is read into this.
struct ForeignSurvey {
    std::string format;  ///< in words: "Leica GSI-16"
    /// In the file's unit, x east, y north, z up; at least one where there are no observations.
    std::vector<SurveyPoint> points;
    PolarSurvey polar;  ///< angles and distances, where the file has these in place of points
    std::optional<double> unit;         ///< of coordinates, where the file has it [m]
    std::optional<double> std_unit;     ///< of their standard deviations; empty: as of coordinates
    bool has_known_points = false;      ///< those of noise 0 were given, not measured
    std::vector<std::string> notes;     ///< how it was understood, a line each
    std::vector<std::string> guesses;   ///< what was assumed, a line each
    std::vector<LeftOutLine> left_out;  ///< what is no point
};

/// The format of a file, by its content; where that leaves it open, by its name.
/// @param bytes of the file
/// @param file_name of it, also for messages
/// @throws InputError for what is no survey (a spreadsheet, JSON, HDF5, XML of another kind), and
///   for another format than the file's name says
[[nodiscard]] TAUT_IO_EXPORT SurveyFormat detect_survey_format(std::string_view bytes,
                                                               const std::string& file_name);

/// Reads a survey of any of the formats.
/// @param bytes of the file
/// @param file_name of it, also for messages
/// @throws InputError with the line, for a file that is cut, a number that is not finite, units
///   that differ, neither coordinates nor observations, no observations where these are to be
///   taken, more than 64 MiB, and as detect_survey_format()
[[nodiscard]] TAUT_IO_EXPORT ForeignSurvey read_foreign_survey(
    std::string_view bytes, const std::string& file_name, const SurveyFileOptions& options = {});

}  // namespace taut
