// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "files/parse_number.hpp"

namespace taut {

/// Whether text, behind any apostrophes, begins as what a spreadsheet runs when it opens a CSV
/// file.
[[nodiscard]] inline bool begins_as_formula(std::string_view text) {
    const size_t first = text.find_first_not_of('\'');
    return first != std::string_view::npos &&
           std::string_view("=+-@\t\r").find(text[first]) != std::string_view::npos;
}

/// Text as one CSV field: in quotes where a reader could see a separator, a quote, a comment, the
/// end of the line or blanks around the field in it.
[[nodiscard]] inline std::string quoted_csv_field(const std::string& text) {
    if (!text.empty() && text.find_first_of(",;\"\r\n\t ") == std::string::npos &&
        !text.starts_with('#')) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + '"';
}

/// quoted_csv_field(). Text that a spreadsheet would take for a formula is led by an apostrophe,
/// unless it is a number: names may come from anybody.
[[nodiscard]] inline std::string csv_field(std::string text) {
    if (begins_as_formula(text) && !parse_number(text)) {
        text.insert(0, 1, '\'');
    }
    return quoted_csv_field(text);
}

/// The text that csv_field() led by an apostrophe, without it.
[[nodiscard]] inline std::string without_formula_guard(std::string field) {
    if (field.starts_with('\'') && begins_as_formula(field)) {
        field.erase(0, 1);
    }
    return field;
}

}  // namespace taut
