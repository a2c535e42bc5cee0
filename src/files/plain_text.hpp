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

}  // namespace taut
