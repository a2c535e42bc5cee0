// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// Separated fields and the line of the file that they start on.
struct CsvRecord {
    int line = 0;
    std::vector<std::string> fields;  ///< unquoted, without blanks around them
};

/// Splits text into records. The first line with a field determines the separator: a semicolon
/// where it holds one, else a comma where it holds one, else any number of blanks and tabs. A comma
/// inside each of several blank separated words ("A 1,5 2,5 3,5") is taken as a decimal sign.
/// Leaves out empty lines and those that start with #. A field may stand in quotes, "" within them
/// is a quote, and then hold separators and ends of lines. Ends of lines are LF or CR LF. Of a name
/// that csv_field() led by an apostrophe gives the name.
class CsvReader {
public:
    /// @param text without byte order mark; @param file_name for messages; both outlive the reader
    CsvReader(std::string_view text, const std::string& file_name)
        : m_rest(text), m_file_name(file_name) {}

    /// @throws InputError with the line, for a quote that is not closed or is followed by text
    [[nodiscard]] std::optional<CsvRecord> next();

private:
    [[nodiscard]] bool at_separator() const;
    [[nodiscard]] bool at_line_end() const;
    void skip_blanks();
    void skip_line_end();
    void skip_to_field();
    [[noreturn]] void fail_behind_quote() const;
    std::string quoted_field();
    std::string plain_field();

    std::string_view m_rest;
    const std::string& m_file_name;
    int m_line = 1;
    char m_separator = '\0';  ///< ' ' stands for blanks and tabs
};

}  // namespace taut
