// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/survey_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <ranges>

#include "io/csv_reader.hpp"
#include "io/message.hpp"
#include "taut/io/file.hpp"
#include "taut/io/input_error.hpp"

namespace taut {
namespace {

constexpr std::array<std::string_view, 7> columns{"id", "x", "y", "z", "sx", "sy", "sz"};
constexpr size_t without_std = 4;  ///< columns
constexpr size_t with_std = 7;

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

/// "1,5", "-0,25": digits on both sides of one comma.
bool has_decimal_comma(std::string text) {
    const size_t comma = text.find(',');
    const auto is_digit = [&text](size_t i) {
        return i < text.size() && text[i] >= '0' && text[i] <= '9';
    };
    if (comma == std::string::npos || comma == 0 || !is_digit(comma - 1) || !is_digit(comma + 1)) {
        return false;
    }
    text[comma] = '.';
    return parse_number(text).has_value();
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

/// One record as a point, or as the header.
class PointParser {
public:
    PointParser(const CsvRecord& record, const std::string& file_name)
        : m_record(record), m_file_name(file_name) {}

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_record.line), what);
    }

    /// @param expected fields of the records before, 0 for the first
    void check_count(size_t expected) const {
        const size_t found = m_record.fields.size();
        if (expected == 0 && found != without_std && found != with_std) {
            fail(fmt::format("has {} fields, expected {} (id,x,y,z) or {} (id,x,y,z,sx,sy,sz)",
                             found, without_std, with_std));
        }
        if (expected != 0 && found != expected) {
            // Each coordinate cut in two.
            const bool cut = expected == without_std && found == with_std;
            fail(fmt::format("has {} fields, expected {} as in the lines before{}", found, expected,
                             cut ? " (with a decimal point, not a comma)" : ""));
        }
    }

    [[nodiscard]] bool is_header() const {
        return std::ranges::equal(m_record.fields,
                                  columns | std::views::take(m_record.fields.size()), {}, lower);
    }

    [[nodiscard]] SurveyPoint point(bool is_first) const {
        const auto is_number = [](const std::string& field) {
            return parse_number(field) || has_decimal_comma(field);
        };
        if (is_first && std::ranges::none_of(m_record.fields, is_number)) {
            fail("is neither a point nor the header id,x,y,z or id,x,y,z,sx,sy,sz");
        }
        if (m_record.fields[0].empty()) {
            fail("has an empty id");
        }
        for (size_t k = without_std; k < m_record.fields.size(); ++k) {
            if (number(k) < 0.0) {
                fail(fmt::format("{} is {}, expected a standard deviation of at least 0",
                                 columns[k], quote(m_record.fields[k])));
            }
        }
        return {.id = m_record.fields[0],
                .position = {number(1), number(2), number(3)},
                .line = m_record.line};
    }

private:
    [[nodiscard]] double number(size_t column) const {
        const std::string& field = m_record.fields[column];
        const auto value = parse_number(field);
        if (!value) {
            fail(fmt::format("{} is {}, expected a {}", columns[column], quote(field),
                             has_decimal_comma(field) ? "number with a decimal point, not a comma"
                                                      : "finite number"));
        }
        return *value;
    }

    const CsvRecord& m_record;
    const std::string& m_file_name;
};

}  // namespace

std::vector<SurveyPoint> parse_survey_points(std::string_view text, const std::string& file_name) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    if (text.find('\0') != std::string_view::npos) {
        const auto lines = std::ranges::count(text.substr(0, text.find('\0')), '\n');
        throw InputError(file_name, std::to_string(1 + lines), "holds a zero byte, expected text");
    }
    std::vector<SurveyPoint> points;
    CsvReader reader(text, file_name);
    size_t field_count = 0;
    while (const auto record = reader.next()) {
        const PointParser parser(*record, file_name);
        parser.check_count(field_count);
        const bool is_first = field_count == 0;
        field_count = record->fields.size();
        if (!is_first || !parser.is_header()) {
            points.push_back(parser.point(is_first));
        }
    }
    if (points.empty()) {
        throw InputError(file_name, "", "holds no point, expected lines id,x,y,z");
    }
    return points;
}

std::vector<SurveyPoint> read_survey_points(const std::filesystem::path& path) {
    return parse_survey_points(read_file(path), path.string());
}

}  // namespace taut
