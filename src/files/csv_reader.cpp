// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/csv_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "files/csv_field.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// More than any table here has, and more would take memory for nothing.
constexpr size_t most_fields = 1000;
constexpr size_t longest_field = size_t{1} << 16U;  // bytes
constexpr int most_lines = 4'000'000;

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view first_line(std::string_view text) {
    return text.substr(0, text.find('\n'));
}

/// At least four words, as a surveyed point has, with at most one comma in each, and that inside
/// and beside no quote.
bool is_blank_separated_with_decimal_commas(std::string_view line) {
    std::istringstream stream{std::string(line)};
    int words = 0;
    for (std::string word; stream >> word; ++words) {
        if (word.starts_with(',') || word.ends_with(',') || std::ranges::count(word, ',') > 1 ||
            word.find("\",") != std::string::npos || word.find(",\"") != std::string::npos) {
            return false;
        }
    }
    return words >= 4;
}

/// @param line the first that holds fields
char detect_separator(std::string_view line) {
    char found = ' ';
    bool in_quotes = false;
    for (const char c : line) {
        if (c == '"') {
            in_quotes = !in_quotes;
        } else if (!in_quotes && c == ';') {
            return ';';
        } else if (!in_quotes && c == ',') {
            found = ',';
        }
    }
    return is_blank_separated_with_decimal_commas(line) ? ' ' : found;
}

}  // namespace

bool CsvReader::at_separator() const {
    const char c = m_rest.front();
    return m_separator == ' ' ? is_blank(c) : c == m_separator;
}

void CsvReader::skip_blanks() {
    while (!m_rest.empty() && is_blank(m_rest.front())) {
        m_rest.remove_prefix(1);
    }
}

/// Also where the text ends.
bool CsvReader::at_line_end() const {
    return m_rest.empty() || m_rest == "\r" || m_rest.starts_with('\n') ||
           m_rest.starts_with("\r\n");
}

void CsvReader::skip_line_end() {
    const std::string_view ended = first_line(m_rest);
    m_line += ended.size() < m_rest.size() ? 1 : 0;
    m_rest.remove_prefix(std::min(ended.size() + 1, m_rest.size()));
}

void CsvReader::skip_to_field() {
    skip_blanks();
    while (!m_rest.empty() && (m_rest.starts_with('#') || at_line_end())) {
        skip_line_end();
        skip_blanks();
    }
}

void CsvReader::fail_behind_quote() const {
    throw InputError(m_file_name, std::to_string(m_line),
                     "has text behind a closing quote, expected a separator");
}

std::string CsvReader::quoted_field() {
    const int start = m_line;
    std::string field;
    m_rest.remove_prefix(1);
    for (;;) {
        const size_t end = m_rest.find('"');
        if (end == std::string_view::npos) {
            throw InputError(m_file_name, std::to_string(start),
                             "opens a quote that is never closed");
        }
        m_line += static_cast<int>(std::ranges::count(m_rest.substr(0, end), '\n'));
        field += m_rest.substr(0, end);
        m_rest.remove_prefix(end + 1);
        if (!m_rest.starts_with('"')) {
            break;
        }
        field += '"';
        m_rest.remove_prefix(1);
    }
    if (!at_line_end() && !is_blank(m_rest.front()) && !at_separator()) {
        fail_behind_quote();
    }
    return field;
}

std::string CsvReader::plain_field() {
    std::string field;
    while (!at_line_end() && !at_separator()) {
        field += m_rest.front();
        m_rest.remove_prefix(1);
    }
    while (!field.empty() && is_blank(field.back())) {
        field.pop_back();
    }
    return field;
}

std::optional<CsvRecord> CsvReader::next() {
    skip_to_field();
    if (m_rest.empty()) {
        return std::nullopt;
    }
    if (m_separator == '\0') {
        m_separator = detect_separator(first_line(m_rest));
    }
    CsvRecord record{.line = m_line, .fields = {}};
    if (m_line > most_lines) {
        throw InputError(m_file_name, "", fmt::format("has more than {} lines", most_lines));
    }
    for (;;) {
        skip_blanks();
        if (record.fields.size() == most_fields) {
            throw InputError(m_file_name, std::to_string(record.line),
                             fmt::format("has more than {} fields", most_fields));
        }
        record.fields.push_back(
            without_formula_guard(m_rest.starts_with('"') ? quoted_field() : plain_field()));
        if (record.fields.back().size() > longest_field) {
            throw InputError(m_file_name, std::to_string(record.line),
                             fmt::format("has a field of more than {} bytes", longest_field));
        }
        skip_blanks();
        if (at_line_end()) {
            skip_line_end();
            return record;
        }
        if (m_separator != ' ') {
            if (!at_separator()) {
                fail_behind_quote();
            }
            m_rest.remove_prefix(1);
        }
    }
}

}  // namespace taut
