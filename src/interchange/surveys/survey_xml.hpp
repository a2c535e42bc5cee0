// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/xml_name.hpp"

namespace taut {

/// An XML file in memory. pugixml expands no entities but the five of XML and those of characters,
/// opens no other files, and leaves out document types: a hostile file stays as small as it is.
class SurveyXml {
public:
    /// @param text UTF-8; outlives the document
    /// @throws InputError with the line, for what is no XML
    SurveyXml(const std::string& text, const std::string& file_name);

    [[nodiscard]] pugi::xml_node root() const { return m_document.document_element(); }

    /// Elements of a name below a node, at any depth, in the order of the file.
    [[nodiscard]] static std::vector<pugi::xml_node> elements(pugi::xml_node below,
                                                              std::string_view name);

    /// A finite number as the text of an element, or nothing where that is empty or not there.
    /// @throws InputError with the line, for another text
    [[nodiscard]] std::optional<double> number(pugi::xml_node parent, const char* child) const;

    [[nodiscard]] double number(pugi::xml_node at, std::string_view text,
                                std::string_view name) const;

    [[nodiscard]] int line_of(pugi::xml_node node) const;
    [[noreturn]] void fail(pugi::xml_node node, const std::string& what) const;

private:
    [[nodiscard]] int line_at(std::ptrdiff_t offset) const;

    pugi::xml_document m_document;
    const std::string& m_file_name;
    std::vector<std::ptrdiff_t> m_line_starts;
};

}  // namespace taut
