// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace taut {

/// Keys of COMPAS are whole numbers or, in a graph, any text, which then stands in the quotes of
/// Python inside the JSON key: "'A'".
[[nodiscard]] inline std::string_view without_quotes(std::string_view key) {
    const bool quoted =
        key.size() >= 2 && (key.front() == '\'' || key.front() == '"') && key.back() == key.front();
    return quoted ? key.substr(1, key.size() - 2) : key;
}

/// The order of nodes: whole numbers by size, before all other keys.
struct KeyOrder {
    bool operator()(const std::string& a, const std::string& b) const {
        return std::pair(rank(a), std::string_view(a)) < std::pair(rank(b), std::string_view(b));
    }

private:
    static std::pair<bool, long long> rank(std::string_view key) {
        long long number = 0;
        const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
        const bool whole = error == std::errc() && end == key.data() + key.size();
        return {!whole, whole ? number : 0};
    }
};

/// Index of each node by its key.
using NodeIndex = std::map<std::string, int, KeyOrder>;

/// The two node keys in "(u, v)", "u, v" or "u-v"; none where the text is no such pair. Where a
/// node's key holds a hyphen, the split that gives two known nodes is taken.
[[nodiscard]] inline std::optional<std::pair<std::string, std::string>> split_edge_key(
    std::string_view text, const NodeIndex& nodes) {
    const auto trimmed = [](std::string_view part) {
        while (part.starts_with(' ')) {
            part.remove_prefix(1);
        }
        while (part.ends_with(' ')) {
            part.remove_suffix(1);
        }
        return std::string(without_quotes(part));
    };
    if (text.starts_with('(') && text.ends_with(')')) {
        text = text.substr(1, text.size() - 2);
    }
    const char separator = text.find(',') != std::string_view::npos ? ',' : '-';
    std::optional<std::pair<std::string, std::string>> found;
    for (size_t at = text.find(separator, 1); at < text.size(); at = text.find(separator, at + 1)) {
        std::pair keys(trimmed(text.substr(0, at)), trimmed(text.substr(at + 1)));
        if (keys.first.empty() || keys.second.empty()) {
            continue;
        }
        if (nodes.contains(keys.first) && nodes.contains(keys.second)) {
            return keys;
        }
        if (!found) {
            found = std::move(keys);
        }
    }
    return found;
}

}  // namespace taut
