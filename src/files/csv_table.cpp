// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/csv_table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

CsvTable::CsvTable(std::string_view text, std::string file_name, CsvColumns columns,
                   std::string_view nothing)
    : m_file_name(std::move(file_name)), m_columns(std::move(columns)) {
    CsvReader reader(table_text(text, m_file_name), m_file_name);
    auto record = reader.next();
    const size_t count = record ? record->fields.size() : 0;
    const bool is_header =
        record && count <= m_columns.names.size() &&
        std::equal(record->fields.begin(), record->fields.end(), m_columns.names.begin());
    if (m_columns.header == CsvColumns::Header::required &&
        (!is_header || count + m_columns.optional < m_columns.names.size())) {
        throw InputError(m_file_name, record ? std::to_string(record->line) : "",
                         "does not start with the header " + columns_text());
    }
    if (record && m_columns.header == CsvColumns::Header::by_name) {
        find_columns(*record);
        record = reader.next();
    } else if (record) {
        take_columns(*record);
        record = is_header ? reader.next() : std::move(record);
    }
    for (; record; record = reader.next()) {
        if (record->fields.size() != count) {
            fail(*record, fmt::format("has {} fields, expected {} as in the lines before",
                                      record->fields.size(), count));
        }
        m_rows.push_back(std::move(*record));
    }
    if (m_rows.empty() && !nothing.empty()) {
        throw InputError(m_file_name, "",
                         fmt::format("{}, expected lines {}", nothing, columns_text()));
    }
}

double CsvTable::number(const CsvRecord& row, size_t column) const {
    const auto value = parse_number(text(row, column));
    if (!value) {
        refuse(row, column, "a finite number");
    }
    return *value;
}

void CsvTable::refuse(const CsvRecord& row, size_t column, const std::string& expected) const {
    fail(row, fmt::format("{} is {}, expected {}", m_columns.names[column],
                          quote(text(row, column)), expected));
}

void CsvTable::fail(const CsvRecord& row, const std::string& what) const {
    throw InputError(m_file_name, std::to_string(row.line), what);
}

/// "edge,tension[,std]"
std::string CsvTable::columns_text() const {
    const auto needed = m_columns.names.end() - static_cast<std::ptrdiff_t>(m_columns.optional);
    std::string text = fmt::format("{}", fmt::join(m_columns.names.begin(), needed, ","));
    return m_columns.optional == 0
               ? text
               : fmt::format("{}[,{}]", text, fmt::join(needed, m_columns.names.end(), ","));
}

void CsvTable::find_columns(const CsvRecord& header) {
    for (const std::string& name : m_columns.names) {
        const auto found = std::ranges::find(header.fields, name);
        if (found == header.fields.end()) {
            fail(header, fmt::format("has no column {}, expected {}", name, columns_text()));
        }
        m_field_of.push_back(static_cast<size_t>(found - header.fields.begin()));
    }
}

void CsvTable::take_columns(const CsvRecord& first) {
    const size_t count = first.fields.size();
    if (count > m_columns.names.size() || count + m_columns.optional < m_columns.names.size()) {
        fail(first, fmt::format("has {} fields, expected {}", count, columns_text()));
    }
    for (size_t k = 0; k < count; ++k) {
        m_field_of.push_back(k);
    }
}

std::vector<std::string> first_fields(std::string_view text, const std::string& file_name) {
    CsvReader reader(plain_text(text, file_name), file_name);
    auto first = reader.next();
    return first ? std::move(first->fields) : std::vector<std::string>();
}

}  // namespace taut
