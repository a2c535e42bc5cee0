// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/message.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// A key of the file can be as long as the file: places are cut after so many bytes.
constexpr size_t longest_place = 200;

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

std::string printable(std::string text) {
    std::ranges::replace_if(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
}

std::string error_text(int code) {
    return std::generic_category().message(code);
}

InputError::InputError(const std::string& file, const std::string& place, const std::string& what)
    : std::runtime_error(printable(at_place(file, place, what))) {}

}  // namespace taut
