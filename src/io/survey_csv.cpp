// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/survey_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

#include "files/csv_field.hpp"
#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "survey/covariance.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"

namespace taut {
namespace {

constexpr std::array<std::string_view, 10> survey_columns{"id", "x",  "y",   "z",   "sx",
                                                          "sy", "sz", "rxy", "rxz", "ryz"};

/// The columns of a line, which follow from their number.
struct Layout {
    size_t count = 0;  ///< 3, 6 or 9 without ids, 4, 7 or 10 with; 0: not known yet

    [[nodiscard]] bool valid() const {
        return count >= 3 && count <= survey_columns.size() && x() <= 1;
    }
    [[nodiscard]] size_t x() const { return count % 3; }  ///< field of the first coordinate
    [[nodiscard]] bool has_ids() const { return x() == 1; }
    [[nodiscard]] bool has_std() const { return count > 4; }
    [[nodiscard]] bool has_correlations() const { return count > 7; }
    [[nodiscard]] std::string_view name(size_t field) const {
        return survey_columns[field + 1 - x()];
    }
};

constexpr std::string_view layouts = "[id,]x,y,z[,sx,sy,sz[,rxy,rxz,ryz]]";

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

/// One record as a point, or as the header.
class PointParser {
public:
    PointParser(const CsvRecord& record, const std::string& file_name)
        : m_record(record), m_file_name(file_name), m_layout{record.fields.size()} {}

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_record.line), what);
    }

    /// @param expected layout of the records before
    void check_count(const Layout& expected) const {
        const size_t found = m_layout.count;
        if (expected.count == 0 && !m_layout.valid()) {
            fail(fmt::format("has {} fields, expected {}: 3, 4, 6, 7, 9 or 10", found, layouts));
        }
        // Standard deviations may be left out of a line, all three of them.
        const bool lacks_std =
            expected.has_std() && !expected.has_correlations() && found + 3 == expected.count;
        if (expected.count != 0 && found != expected.count && !lacks_std) {
            // Each coordinate cut in two.
            const bool cut = !expected.has_std() && found == expected.count + 3;
            fail(fmt::format("has {} fields, expected {} as in the lines before{}", found,
                             expected.count, cut ? " (with a decimal point, not a comma)" : ""));
        }
    }

    [[nodiscard]] const Layout& layout() const { return m_layout; }

    [[nodiscard]] bool is_header() const {
        for (size_t k = 0; k < m_layout.count; ++k) {
            if (in_lower_case(m_record.fields[k]) != m_layout.name(k)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] SurveyPoint point(bool is_first) const {
        const auto is_number = [](const std::string& field) {
            return parse_number(field) || has_decimal_comma(field);
        };
        if (is_first && std::ranges::none_of(m_record.fields, is_number)) {
            fail(fmt::format("is neither a point nor the header {}", layouts));
        }
        const size_t x = m_layout.x();
        SurveyPoint point{.id = m_layout.has_ids() ? m_record.fields[0] : "",
                          .position = {number(x), number(x + 1), number(x + 2)},
                          .line = m_record.line};
        if (m_layout.has_std() && !has_empty_std()) {
            point.noise_std = Eigen::Vector3d(std_of(x + 3), std_of(x + 4), std_of(x + 5));
        }
        if (m_layout.has_correlations()) {
            point.noise_correlations = {number(x + 6), number(x + 7), number(x + 8)};
            if (!are_possible_correlations(point.noise_correlations)) {
                fail(fmt::format(
                    "rxy, rxz, ryz are {}, {}, {}, expected correlations that three "
                    "coordinates can have: their matrix is not positive definite",
                    m_record.fields[x + 6], m_record.fields[x + 7], m_record.fields[x + 8]));
            }
        }
        return point;
    }

private:
    /// As a spreadsheet writes a point that has none.
    [[nodiscard]] bool has_empty_std() const {
        const auto first = m_record.fields.begin() + static_cast<std::ptrdiff_t>(m_layout.x()) + 3;
        return !m_layout.has_correlations() &&
               std::all_of(first, first + 3, [](const std::string& f) { return f.empty(); });
    }

    [[nodiscard]] double number(size_t column) const {
        const std::string& field = m_record.fields[column];
        const auto value = parse_number(field);
        if (!value) {
            fail(fmt::format("{} is {}, expected a {}", m_layout.name(column), quote(field),
                             has_decimal_comma(field) ? "number with a decimal point, not a comma"
                                                      : "finite number"));
        }
        return *value;
    }

    [[nodiscard]] double std_of(size_t column) const {
        const double value = number(column);
        if (value < 0.0) {
            fail(fmt::format("{} is {}, expected a standard deviation of at least 0",
                             m_layout.name(column), quote(m_record.fields[column])));
        }
        return value;
    }

    const CsvRecord& m_record;
    const std::string& m_file_name;
    Layout m_layout;
};

}  // namespace

std::vector<SurveyPoint> parse_survey_points(std::string_view text, const std::string& file_name) {
    std::vector<SurveyPoint> points;
    CsvReader reader(table_text(text, file_name), file_name);
    Layout layout;
    while (const auto record = reader.next()) {
        const PointParser parser(*record, file_name);
        parser.check_count(layout);
        const bool is_first = layout.count == 0;
        layout = is_first ? parser.layout() : layout;
        if (!is_first || !parser.is_header()) {
            points.push_back(parser.point(is_first));
        }
    }
    if (points.empty()) {
        throw InputError(file_name, "", "holds no point, expected lines id,x,y,z");
    }
    return points;
}

std::vector<SurveyPoint> parse_pts_points(std::string_view text, const std::string& file_name) {
    return read_pts(std::string(table_text(text, file_name)), file_name).points;
}

std::vector<SurveyPoint> read_survey_points(const std::filesystem::path& path) {
    const std::string text = read_table(path);
    return in_lower_case(path.extension().string()) == ".pts"
               ? parse_pts_points(text, path.string())
               : parse_survey_points(text, path.string());
}

std::string survey_to_csv(const std::vector<SurveyPoint>& points) {
    const bool has_std = std::ranges::any_of(
        points, [](const SurveyPoint& point) { return point.noise_std.has_value(); });
    const bool has_correlations = std::ranges::any_of(
        points, [](const SurveyPoint& point) { return !point.noise_correlations.isZero(0.0); });
    std::string result = has_correlations ? "id,x,y,z,sx,sy,sz,rxy,rxz,ryz\n"
                         : has_std        ? "id,x,y,z,sx,sy,sz\n"
                                          : "id,x,y,z\n";
    for (const SurveyPoint& point : points) {
        const Eigen::Vector3d& p = point.position;
        result += fmt::format("{},{},{},{}", point.id.empty() ? "" : csv_field(point.id), p.x(),
                              p.y(), p.z());
        if (point.noise_std || has_correlations) {
            const Eigen::Vector3d std_dev = point.noise_std.value_or(Eigen::Vector3d::Zero());
            result += fmt::format(",{},{},{}", std_dev.x(), std_dev.y(), std_dev.z());
        }
        if (has_correlations) {
            const Eigen::Vector3d& r = point.noise_correlations;
            result += fmt::format(",{},{},{}", r.x(), r.y(), r.z());
        }
        result += '\n';
    }
    return result;
}

}  // namespace taut
