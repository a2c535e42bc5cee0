// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/imported_structure.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "files/message.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

void support_boundary(ImportedStructure& structure) {
    for (ImportedNode& node : structure.nodes) {
        node.is_support |= node.is_boundary;
    }
}

void support_named(ImportedStructure& structure, std::string_view text,
                   const std::string& file_name) {
    std::map<std::string_view, ImportedNode*> node_of;
    for (ImportedNode& node : structure.nodes) {
        node_of.emplace(node.id, &node);
    }
    text = table_text(text, file_name);
    bool any = false;
    for (int line = 1; !text.empty(); ++line) {
        const size_t end = std::min(text.find('\n'), text.size());
        std::string_view rest = text.substr(0, end);
        rest = rest.substr(0, rest.find('#'));
        text.remove_prefix(std::min(end + 1, text.size()));
        constexpr std::string_view separators = " \t\r,;";
        for (;;) {
            rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
            if (rest.empty()) {
                break;
            }
            const std::string_view id = rest.substr(0, rest.find_first_of(separators));
            rest.remove_prefix(id.size());
            const auto found = node_of.find(id);
            if (found == node_of.end()) {
                throw InputError(file_name, std::to_string(line),
                                 fmt::format("{} is no node of {}", quote(id), structure.file));
            }
            found->second->is_support = true;
            any = true;
        }
    }
    if (!any) {
        throw InputError(file_name, "", "names no node, expected the supports");
    }
}

}  // namespace taut
