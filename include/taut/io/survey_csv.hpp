// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Reads surveyed points, one a line: [id,] x, y, z [m], and with them or not the standard
/// deviations sx, sy, sz of their noise [m], and behind these or not its correlations rxy, rxz,
/// ryz. Without an id, or with an empty one, the point is a target without a name. The fields are
/// separated by commas, semicolons, or blanks and tabs, as in the first line that holds any, and
/// are as many in every line: 3, 4, 6, 7, 9 or 10; but of 6 or 7, sx, sy, sz may be left out of a
/// line behind the first, which then has no standard deviations. That line may be the header with
/// these names, in lower or upper case. An id may stand in quotes, "" within them means a quote.
/// Left out are empty lines and those that start with #. Numbers have a decimal point.
/// @param file_name for messages
/// @return the points in the order of the file, at least one, positions finite [m]
/// @throws InputError with the line, for anything else
[[nodiscard]] TAUT_IO_EXPORT std::vector<SurveyPoint> parse_survey_points(
    std::string_view text, const std::string& file_name);

/// Reads a PTS point file: the number of points, then a line each, x y z [m], with or without
/// intensity and colour behind. All targets are without a name.
/// @throws InputError with the line, for anything else, and another number of points
[[nodiscard]] TAUT_IO_EXPORT std::vector<SurveyPoint> parse_pts_points(
    std::string_view text, const std::string& file_name);

/// A file whose name ends in .pts as PTS, any other as parse_survey_points().
/// @throws InputError as these two and read_file()
[[nodiscard]] TAUT_IO_EXPORT std::vector<SurveyPoint> read_survey_points(
    const std::filesystem::path& path);

/// Points as parse_survey_points() reads them back to the last bit, with standard deviations where
/// any point has them (0 for those without), and correlations likewise.
[[nodiscard]] TAUT_IO_EXPORT std::string survey_to_csv(const std::vector<SurveyPoint>& points);

}  // namespace taut
