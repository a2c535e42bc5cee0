// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "taut/files/input_error.hpp"

namespace taut {

/// The text of a file without its byte order mark.
/// @param file_name for messages
/// @throws InputError with the line of a zero byte, which no text holds
[[nodiscard]] inline std::string_view plain_text(std::string_view text,
                                                 const std::string& file_name) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    if (const size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const auto lines = std::ranges::count(text.substr(0, zero), '\n');
        throw InputError(file_name, std::to_string(1 + lines), "holds a zero byte, expected text");
    }
    return text;
}

/// That the last line of a table ends as those before it do. A file that was cut within a line ends
/// without, and what is left of its last number or name is often another one. A line of blanks, or
/// of the end-of-file sign of DOS, holds nothing that can be cut; and a single line shows nothing.
/// @throws InputError with the line
inline void require_last_line_break(std::string_view text, const std::string& file_name) {
    const size_t end = text.find_last_of("\r\n");
    if (end == std::string_view::npos ||
        text.find_first_not_of(" \t\x1A", end + 1) == std::string_view::npos) {
        return;
    }
    const auto feeds = std::ranges::count(text, '\n');
    const auto lines = feeds > 0 ? feeds : std::ranges::count(text, '\r');
    throw InputError(file_name, std::to_string(1 + lines),
                     "is the last line and has no line break, expected one as behind all others: "
                     "is the file whole?");
}

/// plain_text() of a table of lines, the last of which is whole.
/// @throws InputError as plain_text() and require_last_line_break()
[[nodiscard]] inline std::string_view table_text(std::string_view text,
                                                 const std::string& file_name) {
    text = plain_text(text, file_name);
    require_last_line_break(text, file_name);
    return text;
}

}  // namespace taut
