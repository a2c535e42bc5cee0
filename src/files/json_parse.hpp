// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "files/json_value.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

/// Parses JSON strictly: UTF-8, no key twice in an object, no number too large for a double,
/// at most 64 levels deep.
/// @param file_name for messages
/// @throws InputError at a line and column, or at a JSON pointer
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::string& file_name);

/// What a reader makes of a JSON file's root.
/// @param read takes a JsonValue; where it takes a type for granted that the file does not have,
///   nlohmann-json throws, which is an error of the file, too
/// @throws InputError as parse_json() and `read`
template <class Read>
[[nodiscard]] auto read_json(std::string_view text, const std::string& file_name,
                             const Read& read) {
    const nlohmann::json json = parse_json(text, file_name);
    try {
        return read(JsonValue(json, file_name));
    } catch (const nlohmann::json::exception&) {
        throw InputError(file_name, "", "holds a value of another type than its place asks for");
    }
}

}  // namespace taut
