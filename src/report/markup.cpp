// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/markup.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace taut::report {
namespace {

/// Number of bytes of the UTF-8 character at the start of a text that is not empty, or 0 where the
/// bytes are none, or one that XML 1.0 forbids.
std::size_t valid_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) {
        const bool allowed = first >= 0x20 || first == '\t' || first == '\n' || first == '\r';
        return allowed && first != 0x7F ? 1 : 0;
    }
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) {
        return 0;
    }
    std::uint32_t code = first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return 0;
        }
        code = (code << 6) | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    const bool control = code < 0xA0;
    const bool beyond = code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF;
    return code < smallest[length] || surrogate || control || beyond ? 0 : length;
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
