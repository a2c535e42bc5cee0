// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/csv_reader.hpp"

namespace taut {

/// The columns of a table by the names in its header.
struct CsvColumns {
    enum class Header {
        optional,  ///< the first line may be the header
        required,  ///< the first line must be the header
        by_name    ///< the header names these columns among others, in any order
    };
    std::vector<std::string> names;
    size_t optional = 0;  ///< so many of the last may be missing, then from all lines
    Header header = Header::optional;
};

/// A CSV table whose lines have as many fields as its columns. Every message names the file and the
/// line.
class CsvTable {
public:
    /// @param nothing what an empty table lacks, "holds no turn"; empty: it may be empty
    /// @throws InputError as CsvReader and table_text(), for another header, a line with another
    ///   number of fields, and an empty table
    CsvTable(std::string_view text, std::string file_name, CsvColumns columns,
             std::string_view nothing);

    /// Lines behind the header.
    [[nodiscard]] const std::vector<CsvRecord>& rows() const { return m_rows; }
    /// Whether the table has an optional column.
    [[nodiscard]] bool has(size_t column) const { return column < m_field_of.size(); }
    [[nodiscard]] const std::string& text(const CsvRecord& row, size_t column) const {
        return row.fields[m_field_of[column]];
    }
    /// @throws InputError for what is no finite number
    [[nodiscard]] double number(const CsvRecord& row, size_t column) const;
    /// Refuses a field: "tension is '-3', expected ...".
    [[noreturn]] void refuse(const CsvRecord& row, size_t column,
                             const std::string& expected) const;
    [[noreturn]] void fail(const CsvRecord& row, const std::string& what) const;

private:
    [[nodiscard]] std::string columns_text() const;
    void find_columns(const CsvRecord& header);
    void take_columns(const CsvRecord& first);

    std::string m_file_name;
    CsvColumns m_columns;
    std::vector<size_t> m_field_of;  ///< by column
    std::vector<CsvRecord> m_rows;
};

/// The first line that holds something, of a text with or without byte order mark.
/// @throws InputError as CsvReader and plain_text()
[[nodiscard]] std::vector<std::string> first_fields(std::string_view text,
                                                    const std::string& file_name);

}  // namespace taut
