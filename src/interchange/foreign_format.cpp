// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/foreign_format.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "files/message.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr std::array<std::string_view, 12> obj_keywords{"v", "vn", "vt",     "vp",     "l", "f",
                                                        "p", "g",  "mtllib", "usemtl", "o", "s"};

bool starts_json(std::string_view text) {
    const size_t start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && (text[start] == '{' || text[start] == '[');
}

/// The first line that is neither empty nor a comment.
std::string_view first_line_with_content(std::string_view text) {
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
        if (!line.empty() && !line.starts_with('#')) {
            return line;
        }
    }
    return {};
}

}  // namespace

ForeignFormat detect_format(std::string_view text, const std::string& file_name) {
    if (text.empty()) {
        throw InputError(file_name, "", "is empty, expected a net");
    }
    if (text.starts_with("\x89HDF")) {
        throw InputError(file_name, "", "is an HDF5 file, expected a net as JSON, CSV or OBJ");
    }
    text = plain_text(text, file_name);
    if (starts_json(text)) {
        return ForeignFormat::json;
    }
    const std::string_view line = first_line_with_content(text);
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
    if (std::ranges::find(obj_keywords, word) != obj_keywords.end()) {
        return ForeignFormat::obj;
    }
    if (line.find_first_of(",;") != std::string_view::npos) {
        return ForeignFormat::csv;
    }
    throw InputError(file_name, "",
                     fmt::format("starts with {}: is neither JSON (COMPAS, JAX FDM), nor OBJ, nor "
                                 "a CSV file of nodes",
                                 quote(line)));
}

ForeignFormat format_named(std::string_view name, std::string_view text) {
    if (name == "compas" || (name == "jax-fdm" && starts_json(text))) {
        return ForeignFormat::json;
    }
    if (name == "csv" || name == "jax-fdm") {
        return ForeignFormat::csv;
    }
    if (name == "obj") {
        return ForeignFormat::obj;
    }
    throw std::invalid_argument(
        fmt::format("there is no format {}: expected compas, jax-fdm, csv or obj", quote(name)));
}

}  // namespace taut
