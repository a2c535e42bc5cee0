// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/markup.hpp"

#include <cstddef>

#include "files/utf8.hpp"

namespace taut::report {
namespace {

/// Number of bytes of the character at the start of a text, or 0 where it is none, or one that XML
/// 1.0 forbids or a page should not hold.
std::size_t valid_character(std::string_view text) {
    const auto [size, code] = first_character(text);
    const bool is_blank = code == '\t' || code == '\n' || code == '\r';
    const bool is_control = (code < 0x20 && !is_blank) || (code >= 0x7F && code < 0xA0);
    return is_control || code == 0xFFFE || code == 0xFFFF ? 0 : size;
}

}  // namespace

std::string escape(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = valid_character(text);
        if (length == 0) {
            escaped += "\uFFFD";
        } else if (text[0] == '&') {
            escaped += "&amp;";
        } else if (text[0] == '<') {
            escaped += "&lt;";
        } else if (text[0] == '>') {
            escaped += "&gt;";
        } else if (text[0] == '"') {
            escaped += "&quot;";
        } else if (text[0] == '\'') {
            escaped += "&#39;";
        } else {
            escaped += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return escaped;
}

}  // namespace taut::report
