// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>
#include <string_view>

namespace taut {

/// A name of XML without its namespace.
[[nodiscard]] inline std::string_view without_namespace(std::string_view name) {
    const size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// The name of an element without its namespace.
[[nodiscard]] inline std::string_view local_name(pugi::xml_node node) {
    return without_namespace(node.name());
}

}  // namespace taut
