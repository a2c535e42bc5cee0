// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/xlsx_sheet.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "files/csv_field.hpp"
#include "files/message.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// As of text files: files/csv_reader.cpp, interchange/surveys/foreign_survey.cpp.
constexpr size_t most_columns = 1000;
/// So many numbers in a row are a point.
constexpr int coordinates = 3;
constexpr size_t largest_text = size_t{64} << 20U;

}  // namespace

SheetReader::SheetReader(std::string name, const std::string& text, const std::string& part,
                         const std::string& file_name, const XlsxShared& shared)
    : m_name(std::move(name)),
      m_file_name(file_name),
      m_shared(shared),
      m_xml(text, part, file_name) {
    for (const pugi::xml_node row : children_of(child_of(m_xml.root(), "sheetData"), "row")) {
        add(row);
    }
}

bool SheetReader::has_points() const {
    return std::ranges::any_of(m_rows, [](const Row& row) { return row.numbers >= coordinates; });
}

std::string SheetReader::to_csv() const {
    refuse_merged_rows();
    std::set<int> columns;
    for (const Row& row : m_rows) {
        for (const auto& [column, cell] : row.cells) {
            columns.insert(column);
        }
    }
    if (columns.size() > most_columns) {
        fail(0, fmt::format("has more than {} columns", most_columns));
    }
    std::string text;
    int line = 1;
    for (const Row& row : m_rows) {
        text.append(static_cast<size_t>(row.number - line), '\n');
        line = row.number + 1;
        const std::string fields = line_of(row, *columns.begin(), *columns.rbegin());
        // Blanks alone make no row.
        text += (fields.find_first_not_of(',') == std::string::npos ? "" : fields) + '\n';
        if (text.size() > largest_text) {
            fail(row.number,
                 fmt::format("is where the table becomes larger than {} MiB", largest_text >> 20U));
        }
    }
    return text;
}

/// @param row 0: of the whole sheet
void SheetReader::fail(int row, const std::string& what) const {
    throw InputError(m_file_name, row > 0 ? std::to_string(row) : "",
                     row > 0 ? what : fmt::format("its sheet {} {}", quote(m_name), what));
}

void SheetReader::add(pugi::xml_node node) {
    Row row{.number = m_last + 1, .cells = {}};
    if (const char* const given = node.attribute("r").as_string(); *given != '\0') {
        const auto reference = parse_reference(fmt::format("A{}", given));
        if (!reference || reference->row <= m_last) {
            fail(m_last, fmt::format("is followed by row {}, expected a later one, of 1048576 "
                                     "at most",
                                     quote(given)));
        }
        row.number = reference->row;
    }
    m_last = row.number;
    int column = 0;
    for (const pugi::xml_node cell : children_of(node, "c")) {
        const char* const given = cell.attribute("r").as_string();
        const auto reference = parse_reference(
            *given == '\0' ? to_string({.column = column + 1, .row = row.number}) : given);
        if (!reference || reference->column <= column) {
            fail(row.number,
                 fmt::format("names the cell {}, expected one behind those before", quote(given)));
        }
        column = reference->column;
        if (holds_value(cell)) {
            row.cells.emplace_back(column, cell);
            row.numbers += holds_number(cell, m_shared) ? 1 : 0;
        }
    }
    if (!row.cells.empty()) {
        m_rows.push_back(std::move(row));
    }
}

/// A value that stands for several rows would be missing in all but the first.
void SheetReader::refuse_merged_rows() const {
    std::vector<int> numbered;
    for (const Row& row : m_rows) {
        if (row.numbers >= 2) {
            numbered.push_back(row.number);
        }
    }
    for (const pugi::xml_node merged :
         children_of(child_of(m_xml.root(), "mergeCells"), "mergeCell")) {
        const std::string_view range = merged.attribute("ref").as_string();
        const size_t colon = std::min(range.find(':'), range.size());
        const auto first = parse_reference(range.substr(0, colon));
        const auto last = parse_reference(range.substr(std::min(colon + 1, range.size())));
        if (!first || !last) {
            continue;
        }
        const auto second = std::ranges::lower_bound(numbered, first->row + 1);
        if (second != numbered.end() && *second <= last->row) {
            fail(first->row, fmt::format("begins the merged cells {}, expected a cell of its "
                                         "own in each row of the table",
                                         range));
        }
    }
}

std::string SheetReader::text_of(const Row& row, int column, pugi::xml_node cell) const {
    std::string text;
    try {
        text = value_text(cell, m_shared);
    } catch (const std::invalid_argument& error) {
        fail(row.number, fmt::format("cell {} {}", to_string({.column = column, .row = row.number}),
                                     error.what()));
    }
    std::ranges::replace_if(text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
}

std::string SheetReader::line_of(const Row& row, int first, int last) const {
    std::string line;
    int column = first;
    bool is_remark = false;
    for (const auto& [at, cell] : row.cells) {
        line.append(is_remark ? 1 : static_cast<size_t>(at - column), is_remark ? ' ' : ',');
        column = at;
        const std::string text = text_of(row, at, cell);
        // A name may begin like a remark: coordinates behind it make it one.
        is_remark = is_remark || (at == row.cells.front().first && text.starts_with('#') &&
                                  row.numbers < coordinates);
        if (!text.empty()) {
            line += is_remark ? text : quoted_csv_field(text);
        }
        if (line.size() > largest_text) {
            fail(row.number, "is too long");
        }
    }
    return is_remark ? line : line.append(static_cast<size_t>(last - column), ',');
}

}  // namespace taut
