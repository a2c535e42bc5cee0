// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace taut {

/// Parses JSON strictly: UTF-8, no key twice in an object, no number beyond the range of a double,
/// at most 64 levels deep.
/// @param file_name for messages
/// @throws InputError at a line and column, or at a JSON pointer
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& file_name);

}  // namespace taut
