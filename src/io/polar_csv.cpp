// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/polar_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "files/csv_field.hpp"
#include "files/csv_table.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "taut/files/input_error.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

struct AngleUnit {
    std::string_view name;
    double size;  ///< [rad]
    double full;  ///< of observed angles, where a precision has this unit [rad]
};

constexpr std::array angle_units{
    AngleUnit{"gon", gon, gon},       AngleUnit{"mgon", 1e-3 * gon, gon},
    AngleUnit{"deg", degree, degree}, AngleUnit{"arcsec", degree / 3600.0, degree},
    AngleUnit{"rad", 1.0, 1.0},       AngleUnit{"mrad", 1e-3, 1.0}};

/// The columns, the last three of which may be missing.
enum class PolarColumn { station, target, hz, v, distance, target_height, angle_std, distance_std };
constexpr std::array<std::string_view, 8> polar_columns{
    "station", "target", "hz", "v", "distance", "target_height", "angle_std", "distance_std"};
constexpr size_t needed_columns = 5;

constexpr size_t index(PolarColumn column) {
    return static_cast<size_t>(column);
}

bool is_angle(PolarColumn column) {
    return column == PolarColumn::hz || column == PolarColumn::v ||
           column == PolarColumn::angle_std;
}

/// "hz [gon]" as "hz" and "gon", in small letters.
struct ColumnTitle {
    std::string name;
    std::string unit;
};

ColumnTitle title_of(const std::string& field) {
    const std::string text = in_lower_case(field);
    const auto without_blanks = [](std::string part) {
        std::erase(part, ' ');
        return part;
    };
    const size_t bracket = text.find('[');
    if (bracket == std::string::npos || !text.ends_with(']')) {
        return {.name = without_blanks(text), .unit = ""};
    }
    return {.name = without_blanks(text.substr(0, bracket)),
            .unit = without_blanks(text.substr(bracket + 1, text.size() - bracket - 2))};
}

/// What each field of a line is.
class PolarHeader {
public:
    PolarHeader(const CsvRecord& record, const std::string& file_name,
                std::optional<double> given_unit)
        : m_count(record.fields.size()) {
        const auto fail = [&](const std::string& what) {
            throw InputError(file_name, std::to_string(record.line), what);
        };
        m_field.fill(-1);
        m_unit.fill(1.0);
        for (size_t i = 0; i < m_count; ++i) {
            const ColumnTitle title = title_of(record.fields[i]);
            const auto* const found = std::ranges::find(polar_columns, title.name);
            if (found == polar_columns.end()) {
                fail(
                    fmt::format("has the column {}, expected some of station, target, hz, v, "
                                "distance, target_height, angle_std, distance_std",
                                quote(record.fields[i])));
            }
            const auto column = static_cast<PolarColumn>(found - polar_columns.begin());
            if (m_field[index(column)] >= 0) {
                fail(fmt::format("has the column {} twice", title.name));
            }
            m_field[index(column)] = static_cast<int>(i);
            const auto unit = unit_of(column, title.unit, given_unit);
            if (!unit) {
                fail(title.unit.empty()
                         ? fmt::format("gives no unit of {0}, expected {0} [gon], [deg] or [rad], "
                                       "or a standard deviation of angles with a unit, as 0.3mgon",
                                       title.name)
                         : fmt::format("has {} in {}, expected {}", title.name, quote(title.unit),
                                       is_angle(column) ? "gon, mgon, deg, arcsec, rad or mrad"
                                                        : "m or mm"));
            }
            m_unit[index(column)] = *unit;
        }
        for (size_t k = 0; k < needed_columns; ++k) {
            if (m_field[k] < 0) {
                fail(fmt::format("has no column {}, expected station, target, hz, v, distance",
                                 polar_columns[k]));
            }
        }
    }

    [[nodiscard]] size_t count() const { return m_count; }
    /// Of a column, or -1.
    [[nodiscard]] int field(PolarColumn column) const { return m_field[index(column)]; }
    [[nodiscard]] double unit(PolarColumn column) const { return m_unit[index(column)]; }

private:
    static std::optional<double> unit_of(PolarColumn column, const std::string& name,
                                         std::optional<double> given_unit) {
        if (column == PolarColumn::station || column == PolarColumn::target) {
            return name.empty() ? std::optional(1.0) : std::nullopt;
        }
        if (!is_angle(column)) {
            return name.empty() || name == "m" ? std::optional(1.0)
                   : name == "mm"              ? std::optional(1e-3)
                                               : std::nullopt;
        }
        const auto* const found = std::ranges::find(angle_units, name, &AngleUnit::name);
        return name.empty()                 ? given_unit
               : found == angle_units.end() ? std::nullopt
                                            : std::optional(found->size);
    }

    size_t m_count;
    std::array<int, polar_columns.size()> m_field{};
    std::array<double, polar_columns.size()> m_unit{};
};

/// One line as an observation.
class PolarLine {
public:
    PolarLine(const CsvRecord& record, const PolarHeader& header, const std::string& file_name)
        : m_record(record), m_header(header), m_file_name(file_name) {
        if (record.fields.size() != header.count()) {
            fail(fmt::format("has {} fields, expected {} as the header", record.fields.size(),
                             header.count()));
        }
    }

    [[nodiscard]] std::string name(PolarColumn column) const {
        const std::string& text = m_record.fields[m_header.field(column)];
        if (text.empty()) {
            fail(fmt::format("has no {}, expected a name", polar_columns[index(column)]));
        }
        return text;
    }

    [[nodiscard]] PolarObservation observation() const {
        PolarObservation result{.target = name(PolarColumn::target),
                                .direction = angle(PolarColumn::hz, -1.0),
                                .zenith = angle(PolarColumn::v, 0.0),
                                .distance = positive(PolarColumn::distance),
                                .line = m_record.line};
        if (m_header.field(PolarColumn::target_height) >= 0) {
            result.target_height =
                number(PolarColumn::target_height) * m_header.unit(PolarColumn::target_height);
        }
        if (m_header.field(PolarColumn::angle_std) >= 0) {
            result.angle_std = positive(PolarColumn::angle_std);
        }
        if (m_header.field(PolarColumn::distance_std) >= 0) {
            result.distance_std = positive(PolarColumn::distance_std);
        }
        return in_first_face(std::move(result));
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_record.line), what);
    }

    [[nodiscard]] const std::string& text(PolarColumn column) const {
        return m_record.fields[m_header.field(column)];
    }

    [[nodiscard]] double number(PolarColumn column) const {
        const auto value = parse_number(text(column));
        if (!value) {
            fail(fmt::format("{} is {}, expected a finite number", polar_columns[index(column)],
                             quote(text(column))));
        }
        return *value;
    }

    [[nodiscard]] double positive(PolarColumn column) const {
        const double value = number(column) * m_header.unit(column);
        if (!(value > 0.0 && std::isfinite(value))) {
            fail(fmt::format("{} is {}, expected more than 0", polar_columns[index(column)],
                             quote(text(column))));
        }
        return value;
    }

    /// @param least in full circles
    [[nodiscard]] double angle(PolarColumn column, double least) const {
        const double unit = m_header.unit(column);
        const double circle = 2.0 * std::numbers::pi / unit;
        const double value = number(column);
        constexpr double rounding = 1e-9;
        if (!(value >= (least - rounding) * circle && value <= (1.0 + rounding) * circle)) {
            fail(fmt::format(
                "{} is {}, expected {:.6g} to {:.6g} as its unit says: is the unit "
                "right?",
                polar_columns[index(column)], quote(text(column)), least * circle, circle));
        }
        return value * unit;
    }

    const CsvRecord& m_record;
    const PolarHeader& m_header;
    const std::string& m_file_name;
};

}  // namespace

AngleText parse_angle(std::string_view text) {
    size_t end = text.size();
    while (end > 0 && ((text[end - 1] >= 'a' && text[end - 1] <= 'z'))) {
        --end;
    }
    const auto* const unit = std::ranges::find(angle_units, text.substr(end), &AngleUnit::name);
    std::string_view digits = text.substr(0, end);
    while (digits.ends_with(' ')) {
        digits.remove_suffix(1);
    }
    const auto value = parse_number(digits);
    if (unit == angle_units.end() || !value) {
        throw std::invalid_argument(
            fmt::format("'{}' is no angle: expected a number and a unit, as in 0.3mgon, 1arcsec, "
                        "0.001deg or 0.005mrad",
                        text));
    }
    return {.angle = *value * unit->size, .full_unit = unit->full};
}

DistancePrecision parse_distance_precision(std::string_view text) {
    const auto fail = [&] {
        throw std::invalid_argument(fmt::format(
            "'{}' is no precision of distances: expected a length, as 1mm, or a length and a part "
            "of the distance, as 1mm+1.5ppm",
            text));
    };
    DistancePrecision result{.std_dev = 0.0, .part = 0.0};
    const size_t plus = text.find('+');
    std::string_view ppm = plus == std::string_view::npos ? "0ppm" : text.substr(plus + 1);
    std::string_view length = text.substr(0, plus);
    while (length.ends_with(' ')) {
        length.remove_suffix(1);
    }
    try {
        result.std_dev = parse_length(length);
    } catch (const std::invalid_argument&) {
        fail();
    }
    while (ppm.starts_with(' ')) {
        ppm.remove_prefix(1);
    }
    if (!ppm.ends_with("ppm")) {
        fail();
    }
    ppm.remove_suffix(3);
    while (ppm.ends_with(' ')) {
        ppm.remove_suffix(1);
    }
    const auto parts = parse_number(ppm);
    if (!parts || *parts < 0.0 || !(result.std_dev > 0.0)) {
        fail();
    }
    result.part = 1e-6 * *parts;
    return result;
}

bool is_polar_csv(std::string_view text) {
    try {
        const std::vector<std::string> first = first_fields(text, "");
        const auto has = [&](std::string_view column) {
            return std::ranges::any_of(
                first, [&](const std::string& field) { return title_of(field).name == column; });
        };
        return has("station") && has("target") && has("hz");
    } catch (const InputError&) {
        return false;
    }
}

PolarSurvey parse_polar_csv(std::string_view text, const std::string& file_name,
                            std::optional<double> given_unit) {
    CsvReader reader(table_text(text, file_name), file_name);
    const auto first = reader.next();
    if (!first) {
        throw InputError(file_name, "",
                         "holds no observation, expected lines station,target,hz,v,"
                         "distance below a header");
    }
    const PolarHeader header(*first, file_name, given_unit);
    PolarSurvey survey;
    std::map<std::string, int> number_of;
    while (const auto record = reader.next()) {
        const PolarLine line(*record, header, file_name);
        PolarObservation observation = line.observation();
        const std::string name = line.name(PolarColumn::station);
        const auto [found, is_new] =
            number_of.emplace(name, static_cast<int>(survey.stations.size()));
        if (is_new) {
            survey.stations.push_back({.name = name, .line = record->line});
        }
        observation.station = found->second;
        survey.observations.push_back(std::move(observation));
    }
    if (survey.observations.empty()) {
        throw InputError(file_name, "", "holds no observation behind its header");
    }
    return survey;
}

std::string polar_to_csv(const PolarSurvey& survey) {
    const bool has_height = std::ranges::any_of(
        survey.observations, [](const PolarObservation& one) { return one.target_height != 0.0; });
    const bool has_std = std::ranges::all_of(survey.observations, [](const PolarObservation& one) {
        return one.angle_std > 0.0 && one.distance_std > 0.0;
    });
    std::string result = "station,target,hz [gon],v [gon],distance [m]";
    result += has_height ? ",target_height [m]" : "";
    result += has_std ? ",angle_std [mgon],distance_std [mm]\n" : "\n";
    for (const PolarObservation& one : survey.observations) {
        result += fmt::format("{},{},{:.12g},{:.12g},{:.12g}",
                              csv_field(survey.stations[one.station].name), csv_field(one.target),
                              one.direction / gon, one.zenith / gon, one.distance);
        if (has_height) {
            result += fmt::format(",{:.12g}", one.target_height);
        }
        if (has_std) {
            result +=
                fmt::format(",{:.12g},{:.12g}", 1e3 * one.angle_std / gon, 1e3 * one.distance_std);
        }
        result += '\n';
    }
    return result;
}

}  // namespace taut
