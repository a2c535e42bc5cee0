// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/survey_reader.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "taut/files/input_error.hpp"

namespace taut {

std::vector<TextLine> lines_of(std::string_view text, const std::string& file_name) {
    constexpr size_t most_lines = 4'000'000;
    std::vector<TextLine> lines;
    int number = 1;
    while (!text.empty()) {
        if (lines.size() == most_lines) {
            throw InputError(file_name, "", fmt::format("has more than {} lines", most_lines));
        }
        const size_t end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back({.number = number++, .text = text.substr(0, end)});
        const size_t behind = text.substr(end).starts_with("\r\n") ? 2 : 1;
        text.remove_prefix(std::min(end + behind, text.size()));
    }
    return lines;
}

std::string_view trimmed(std::string_view text) {
    const size_t start = text.find_first_not_of(" \t");
    if (start == std::string_view::npos) {
        return {};
    }
    return text.substr(start, text.find_last_not_of(" \t") - start + 1);
}

std::string in_lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return lower;
}

}  // namespace taut
