// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "files/xlsx_cells.hpp"

namespace taut {

/// One sheet as it stands in an Excel file.
class SheetReader {
public:
    /// @param text XML; @param part its name in the file; @param file_name for messages, outlives
    /// the
    ///   sheet, as does @param shared
    /// @throws InputError for what is no XML, and rows or cells out of order
    SheetReader(std::string name, const std::string& text, const std::string& part,
                const std::string& file_name, const XlsxShared& shared);

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] bool is_empty() const { return m_rows.empty(); }
    /// Whether a row holds three numbers.
    [[nodiscard]] bool has_points() const;

    /// CSV, each row the line of its number, with so many fields as all others. A row that starts
    /// with # is a remark, as in text files.
    /// @throws InputError with the row, as read_xlsx()
    [[nodiscard]] std::string to_csv() const;

private:
    /// A row without its empty cells.
    struct Row {
        int number = 0;
        std::vector<std::pair<int, pugi::xml_node>> cells;  ///< by column, from 1
        int numbers = 0;                                    ///< how many of them
    };

    [[noreturn]] void fail(int row, const std::string& what) const;
    void add(pugi::xml_node node);
    void refuse_merged_rows() const;
    [[nodiscard]] std::string text_of(const Row& row, int column, pugi::xml_node cell) const;
    [[nodiscard]] std::string line_of(const Row& row, int first, int last) const;

    std::string m_name;
    const std::string& m_file_name;
    const XlsxShared& m_shared;
    XlsxXml m_xml;
    std::vector<Row> m_rows;  ///< those that hold something
    int m_last = 0;           ///< number of the last row, also of an empty one
};

}  // namespace taut
