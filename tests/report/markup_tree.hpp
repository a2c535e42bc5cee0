// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace taut::test {

using Tree = boost::property_tree::ptree;

/// @throws boost::property_tree::xml_parser_error where the text is not well-formed
inline Tree parse_xml(const std::string& text) {
    std::istringstream stream(text);
    Tree tree;
    boost::property_tree::read_xml(stream, tree, boost::property_tree::xml_parser::no_concat_text);
    return tree;
}

/// All text inside an element, in order.
inline std::string text_of(const Tree& element) {
    std::string text = element.data();
    for (const auto& [name, child] : element) {
        text += name == "<xmlattr>" ? "" : text_of(child);
    }
    return text;
}

/// All elements of a name below another, in order.
inline std::vector<Tree> elements(const Tree& parent, std::string_view name) {
    std::vector<Tree> found;
    for (const auto& [child_name, child] : parent) {
        if (child_name == name) {
            found.push_back(child);
        }
        for (Tree& deeper : elements(child, name)) {
            found.push_back(std::move(deeper));
        }
    }
    return found;
}

/// The words of a text, in lower case: "NaN" is one, "nanometre" another.
inline std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> found(1);
    for (const char c : text) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (letter) {
            found.back() += static_cast<char>(c | 0x20);
        } else if (!found.back().empty()) {
            found.emplace_back();
        }
    }
    return found;
}

}  // namespace taut::test
