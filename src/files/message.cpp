// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/message.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "files/utf8.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

/// C0, DEL, C1, what breaks lines, and what turns the direction of writing.
bool is_control(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E ||
           code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

/// A key of the file can be as long as the file: places are cut after so many bytes.
constexpr size_t longest_place = 200;

/// And messages after so many.
constexpr size_t longest_message = 2000;

std::string cut(std::string text) {
    if (text.size() > longest_message) {
        text.resize(longest_message);
        text += "...";
    }
    return text;
}

std::string at_place(const std::string& file, std::string_view place, const std::string& what) {
    if (place.empty()) {
        return fmt::format("{}: {}", file, what);
    }
    return fmt::format("{}:{}{}: {}", file, place.substr(0, longest_place),
                       place.size() > longest_place ? "..." : "", what);
}

}  // namespace

std::string quote(std::string_view text) {
    constexpr size_t longest = 40;
    return text.size() > longest ? fmt::format("'{}...'", text.substr(0, longest))
                                 : fmt::format("'{}'", text);
}

std::string printable(std::string_view text, std::string_view kept) {
    const auto is_kept = [kept](std::uint32_t code) {
        return code < 0x80 && kept.find(static_cast<char>(code)) != std::string_view::npos;
    };
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto [size, code] = first_character(text);
        if (size == 0) {
            result += "\uFFFD";
        } else if (is_control(code) && !is_kept(code)) {
            result += fmt::format("\\u{:04x}", code);
        } else {
            result += text.substr(0, size);
        }
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return result;
}

std::string error_text(int code) {
    return std::generic_category().message(code);
}

InputError::InputError(const std::string& file, const std::string& place, const std::string& what)
    : std::runtime_error(printable(cut(at_place(file, place, what)))) {}

}  // namespace taut
