// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "taut/survey/survey.hpp"

namespace taut {

/// Reads surveyed points, one a line: id, x, y, z, and with them or not the standard deviations sx,
/// sy, sz [m]. These are checked (not negative), but NOT USED yet.
/// The fields are separated by commas, semicolons, or blanks and tabs, as in the first line that
/// holds any, and are as many in every line. That line may be the header "id,x,y,z" or
/// "id,x,y,z,sx,sy,sz", in lower or upper case. An id may stand in quotes, "" within them means a
/// quote. Left out are empty lines and those that start with #. Numbers have a decimal point.
/// @param file_name for messages
/// @return the points in the order of the file, at least one, ids not empty, positions finite [m]
/// @throws InputError with the line, for anything else
[[nodiscard]] std::vector<SurveyPoint> parse_survey_points(std::string_view text,
                                                           const std::string& file_name);

/// @throws InputError as parse_survey_points() and read_file()
[[nodiscard]] std::vector<SurveyPoint> read_survey_points(const std::filesystem::path& path);

}  // namespace taut
