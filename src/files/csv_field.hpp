// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace taut {

/// Text as one CSV field: in quotes where a reader could see a separator, a quote, a comment, the
/// end of the line or blanks around the field in it.
[[nodiscard]] inline std::string csv_field(const std::string& text) {
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

}  // namespace taut
