// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "files/csv_field.hpp"
#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/table_header.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr const char* spread_names[] = {"sx", "sy", "sz"};
constexpr const char* place_names[] = {"x", "y", "z"};

/// The lines of a table as points.
class TableParser {
public:
    /// @param is_cloud as of read_survey_table()
    TableParser(const TableHead& head, std::optional<char> decimal, bool is_cloud,
                const std::string& file_name)
        : m_head(head),
          m_decimal(decimal.value_or('\0')),
          m_is_cloud(is_cloud),
          m_file_name(file_name) {}

    /// @param ends_empty whether the last field is empty, so that the line is not cut
    void add(const TextLine& line, const std::vector<std::string>& fields, bool may_be_longer,
             bool ends_empty) {
        m_line = line.number;
        if (fields == m_head.titles) {
            leave_out("the header once more");
            return;
        }
        const TableLayout& layout = m_head.layout;
        std::vector<size_t> empty;
        for (size_t k = 0; k < 3; ++k) {
            if (layout.place[k] >= fields.size() || says_nothing(fields[layout.place[k]])) {
                empty.push_back(k);
            }
        }
        const bool is_short = fields.size() < layout.needed() && !ends_empty;
        if (is_short && count_numbers(fields) < 2) {
            leave_out(fmt::format("no coordinates: {}", quote(trimmed(line.text))));
            return;
        }
        if (empty.size() == 3 || (!empty.empty() && !is_short)) {
            leave_out(fmt::format("no {}", place_names[empty.front()]));
            return;
        }
        if (is_short) {
            fail(fmt::format("has {} fields, expected {}: is the file whole?", fields.size(),
                             layout.to_string()));
        }
        // Behind blanks a remark may stand, but no number: a name of two words moves all columns.
        const bool is_moved = !m_is_cloud && fields.size() > layout.count &&
                              parse_number_field(fields[layout.count]).has_value();
        if (fields.size() > layout.count && (!may_be_longer || is_moved)) {
            fail(
                fmt::format("has {} fields, expected {}: {} (decimal commas between commas, or a "
                            "separator in a name?)",
                            fields.size(), layout.count, layout.to_string()));
        }
        SurveyPoint point{.line = m_line};
        if (layout.id) {
            point.id = without_formula_guard(fields[*layout.id]);
        }
        if (layout.code && *layout.code < fields.size()) {
            point.code = fields[*layout.code];
        }
        for (size_t k = 0; k < 3; ++k) {
            point.position(static_cast<Eigen::Index>(k)) =
                number(fields[layout.place[k]], place_names[k]);
        }
        point.noise_std = spread(fields);
        m_points.push_back(std::move(point));
    }

    [[nodiscard]] char decimal() const { return m_decimal; }
    [[nodiscard]] const std::vector<SurveyPoint>& points() const { return m_points; }
    [[nodiscard]] const std::vector<LeftOutLine>& left_out() const { return m_left_out; }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_line), what);
    }

    void leave_out(std::string reason) {
        m_left_out.push_back({.line = m_line, .reason = std::move(reason)});
    }

    double number(const std::string& field, const char* name) {
        const auto number = parse_number_field(field);
        if (!number || !number->value) {
            fail(fmt::format("{} is {}, expected a finite number", name, quote(field)));
        }
        if (number->decimal != '\0') {
            if (m_decimal != '\0' && number->decimal != m_decimal) {
                fail(fmt::format(
                    "{} is {}, expected a decimal {} as {}", name, quote(field),
                    m_decimal == ',' ? "comma" : "point",
                    m_decimal_line > 0 ? fmt::format("in line {}", m_decimal_line) : "given"));
            }
            if (m_decimal == '\0') {
                m_decimal = number->decimal;
                m_decimal_line = m_line;
            }
        }
        return *number->value;
    }

    std::optional<Eigen::Vector3d> spread(const std::vector<std::string>& fields) {
        if (!m_head.layout.spread) {
            return std::nullopt;
        }
        Eigen::Vector3d std_dev;
        for (size_t k = 0; k < 3; ++k) {
            const size_t column = (*m_head.layout.spread)[k];
            if (column >= fields.size() || says_nothing(fields[column])) {
                return std::nullopt;
            }
            const double value = number(fields[column], spread_names[k]);
            if (value < 0.0) {
                fail(fmt::format("{} is {}, expected a standard deviation of at least 0",
                                 spread_names[k], quote(fields[column])));
            }
            std_dev(static_cast<Eigen::Index>(k)) = value;
        }
        return std_dev;
    }

    const TableHead& m_head;
    char m_decimal;
    bool m_is_cloud;
    int m_decimal_line = 0;
    const std::string& m_file_name;
    int m_line = 0;
    std::vector<SurveyPoint> m_points;
    std::vector<LeftOutLine> m_left_out;
};

/// "Punkt as id, Rechtswert as x"
std::string titles_text(const TableHead& head) {
    const auto title = [&](size_t column) {
        return column < head.titles.size() ? head.titles[column] : std::to_string(column + 1);
    };
    std::vector<std::string> columns;
    if (head.layout.id) {
        columns.push_back(fmt::format("{} as id", title(*head.layout.id)));
    }
    for (size_t k = 0; k < 3; ++k) {
        columns.push_back(fmt::format("{} as {}", title(head.layout.place[k]), place_names[k]));
    }
    if (head.layout.code) {
        columns.push_back(fmt::format("{} as code", title(*head.layout.code)));
    }
    for (size_t k = 0; head.layout.spread && k < 3; ++k) {
        columns.push_back(
            fmt::format("{} as {}", title((*head.layout.spread)[k]), spread_names[k]));
    }
    std::vector<std::string> others;
    for (size_t column = 0; column < head.titles.size(); ++column) {
        if (!head.layout.uses(column)) {
            others.push_back(title(column));
        }
    }
    return fmt::format(
        "columns: {}{}", fmt::join(columns, ", "),
        others.empty() ? "" : fmt::format("; left out: {}", fmt::join(others, ", ")));
}

}  // namespace

ForeignSurvey read_survey_table(const std::string& text, const std::string& file_name,
                                const SurveyFileOptions& options, bool is_cloud) {
    const std::vector<TextLine> lines = lines_of(text, file_name);
    const auto separator = options.separator ? options.separator : detect_table_separator(lines);
    if (!separator) {
        throw InputError(
            file_name, "",
            "holds no point, expected lines of a name and three coordinates, or one of "
            "the formats that taut reads");
    }
    const TableHead head = read_table_head(lines, *separator, options, is_cloud, file_name);
    TableParser parser(head, options.decimal, is_cloud, file_name);
    ForeignSurvey survey{.format = is_cloud ? "XYZ points" : "text table",
                         .unit = head.unit,
                         .std_unit = head.spread_unit,
                         .guesses = head.guesses};
    for (size_t i = head.first; i < lines.size(); ++i) {
        if (!trimmed(lines[i].text).empty() && !is_comment(lines[i].text)) {
            const std::string_view line = lines[i].text;
            parser.add(lines[i], split_fields(lines[i], *separator, file_name),
                       *separator == ' ' || is_cloud,
                       *separator != ' ' && line.find_last_not_of(' ') != std::string_view::npos &&
                           line[line.find_last_not_of(' ')] == *separator);
        }
    }
    survey.notes.push_back(head.titles.empty() || !options.columns.empty()
                               ? fmt::format("columns: {}", head.layout.to_string())
                               : titles_text(head));
    survey.notes.push_back(fmt::format(
        "separator: {}; decimal sign: {}", name_of_separator(*separator),
        parser.decimal() == '\0' ? "none" : (parser.decimal() == ',' ? "comma" : "point")));
    survey.left_out = parser.left_out();
    survey.points = parser.points();
    return survey;
}

}  // namespace taut
