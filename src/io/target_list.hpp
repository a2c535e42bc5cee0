// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "survey/planned_survey.hpp"
#include "taut/export/io.hpp"

namespace taut {

/// Reads a plan of targets: the name of a node a line, in quotes where it holds blanks, commas or
/// semicolons. Left out are empty lines and those that start with #.
/// @param file_name for messages
/// @return nothing where the first line holds more than a name: it is then a survey
/// @throws InputError with the line, where another line holds more, and for an empty file
[[nodiscard]] TAUT_IO_EXPORT std::optional<std::vector<PlannedTarget>> parse_target_list(
    std::string_view text, const std::string& file_name);

}  // namespace taut
