// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// An XML part of an Excel file.
class XlsxXml {
public:
    /// @throws InputError for what is no XML
    XlsxXml(const std::string& text, const std::string& part, const std::string& file_name);

    [[nodiscard]] pugi::xml_node root() const { return m_document.document_element(); }

private:
    pugi::xml_document m_document;
};

/// The first child of a name, which has no namespace.
[[nodiscard]] pugi::xml_node child_of(pugi::xml_node node, std::string_view name);

/// All children of a name.
[[nodiscard]] std::vector<pugi::xml_node> children_of(pugi::xml_node node, std::string_view name);

/// What the cells of all sheets share.
struct XlsxShared {
    std::vector<std::string> texts;
    std::vector<bool> is_date;  ///< by style
    bool starts_1904 = false;   ///< dates count from then
};

/// The texts of sharedStrings.xml.
[[nodiscard]] std::vector<std::string> shared_texts(pugi::xml_node root);

/// The styles of styles.xml that show dates.
[[nodiscard]] std::vector<bool> date_styles(pugi::xml_node root);

/// Rows and columns of a reference count from 1: "B12" is column 2, row 12.
struct XlsxReference {
    int column = 0;
    int row = 0;
};

/// A reference to a cell; nothing for another text, or one beyond the last cell of Excel.
[[nodiscard]] std::optional<XlsxReference> parse_reference(std::string_view text);

/// "B12".
[[nodiscard]] std::string to_string(XlsxReference cell);

/// Whether a cell holds a number, also one that was typed as text.
[[nodiscard]] bool holds_number(pugi::xml_node cell, const XlsxShared& shared);

/// Whether a cell holds anything.
[[nodiscard]] bool holds_value(pugi::xml_node cell);

/// The value of a cell as text: a number with all its digits, a date as 2026-05-31.
/// @throws std::invalid_argument for an error, a formula that was never computed, and what is not
/// in
///   the file: the rest of "cell B12 ..."
[[nodiscard]] std::string value_text(pugi::xml_node cell, const XlsxShared& shared);

}  // namespace taut
