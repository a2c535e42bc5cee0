// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/survey/target_offsets.hpp"

namespace taut {

/// Reads offsets of targets, one a line: target,offset[,std], the target a name in the survey or
/// the code of its kind, lengths with their unit ("3mm") or in metres. The header with these names
/// may be left out; empty lines and those that start with # are.
/// @param file_name for messages
/// @return by target, at least one
/// @throws InputError with the line, for anything else, a target that comes twice and a std that is
///   negative
[[nodiscard]] TAUT_IO_EXPORT std::map<std::string, TargetOffset> parse_target_offsets(
    std::string_view text, const std::string& file_name);

}  // namespace taut
