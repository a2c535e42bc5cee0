// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

// A word of Leica GSI: two digits for what it is, four of information, of which the last is
// the unit, a sign, and 8 digits of data (GSI-8) or 16 (GSI-16, whose lines start with *).
constexpr size_t gsi_prefix = 7;

bool is_gsi_digit(char c) {
    return c >= '0' && c <= '9';
}

struct GsiWord {
    int index = 0;
    char unit = '0';
    bool is_negative = false;
    std::string_view data;
};

/// Takes words off a line.
class GsiLine {
public:
    GsiLine(const TextLine& line, const std::string& file_name)
        : m_line(line), m_rest(trimmed(line.text)), m_file_name(file_name) {
        if (m_rest.starts_with('*')) {
            m_data = 16;
            m_rest.remove_prefix(1);
        }
    }

    [[nodiscard]] bool is_long() const { return m_data == 16; }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_line.number), what);
    }

    [[nodiscard]] std::optional<GsiWord> next() {
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t"), m_rest.size()));
        if (m_rest.empty()) {
            return std::nullopt;
        }
        const bool is_word = m_rest.size() >= gsi_prefix && is_gsi_digit(m_rest[0]) &&
                             is_gsi_digit(m_rest[1]) && (m_rest[6] == '+' || m_rest[6] == '-');
        if (!is_word) {
            fail(fmt::format("holds {}, expected a word of GSI: two digits, four places, a sign",
                             quote(m_rest)));
        }
        if (m_rest.size() < gsi_prefix + m_data) {
            fail(
                fmt::format("ends within the word {}, expected {} digits behind its sign: is the "
                            "file whole?",
                            quote(m_rest), m_data));
        }
        const GsiWord word{.index = 10 * (m_rest[0] - '0') + (m_rest[1] - '0'),
                           .unit = m_rest[5],
                           .is_negative = m_rest[6] == '-',
                           .data = m_rest.substr(gsi_prefix, m_data)};
        m_rest.remove_prefix(gsi_prefix + m_data);
        if (!m_rest.empty() && m_rest.front() != ' ' && m_rest.front() != '\t') {
            fail(fmt::format("goes on with {} behind a word of {} digits, expected a blank",
                             quote(m_rest), m_data));
        }
        return word;
    }

    /// @return [rad]
    [[nodiscard]] double angle(const GsiWord& word) const {
        const auto number = static_cast<double>(digits_of(word));
        double value = 0.0;
        switch (word.unit) {
            case '2':
                value = number / 1e5 * gon;
                break;
            case '3':
                value = number / 1e5 * degree;
                break;
            case '4': {  // dddmmss.s
                const std::int64_t digits = digits_of(word);
                const std::int64_t degrees = digits / 100000;
                const std::int64_t minutes = digits / 1000 % 100;
                const double seconds = static_cast<double>(digits % 1000) / 10.0;
                value = (static_cast<double>(degrees) +
                         (static_cast<double>(minutes) + seconds / 60.0) / 60.0) *
                        degree;
                break;
            }
            case '5':
                value = number / 1e4 * std::numbers::pi / 3200.0;
                break;
            default:
                fail(fmt::format("word {} has the unit {}, expected one of angles: 2, 3, 4, 5",
                                 word.index, quote(std::string(1, word.unit))));
        }
        if (!(value <= 2.0 * std::numbers::pi * (1.0 + 1e-9))) {
            fail(fmt::format("word {} is {}, expected no more than a full circle", word.index,
                             quote(word.data)));
        }
        return word.is_negative ? -value : value;
    }

    /// @return [m]
    [[nodiscard]] double length(const GsiWord& word, bool& is_feet) const {
        const std::int64_t digits = digits_of(word);
        constexpr double foot = 0.3048;
        double divisor = 1.0;
        double unit = 1.0;
        switch (word.unit) {
            case '0':
                divisor = 1e3;
                break;
            case '1':
                divisor = 1e3;
                unit = foot;
                break;
            case '6':
                divisor = 1e4;
                break;
            case '7':
                divisor = 1e4;
                unit = foot;
                break;
            case '8':
                divisor = 1e5;
                break;
            default:
                fail(fmt::format("word {} has the unit {}, expected one of lengths: 0, 1, 6, 7, 8",
                                 word.index, quote(std::string(1, word.unit))));
        }
        is_feet = unit != 1.0;
        // Divided once, so that the number is the nearest to what is written.
        const double value = static_cast<double>(digits) / divisor * unit;
        return word.is_negative ? -value : value;
    }

private:
    [[nodiscard]] std::int64_t digits_of(const GsiWord& word) const {
        std::int64_t digits = 0;
        for (const char c : word.data) {
            if (!is_gsi_digit(c)) {
                fail(fmt::format("word {} is {}, expected digits", word.index, quote(word.data)));
            }
            digits = 10 * digits + (c - '0');
        }
        return digits;
    }

    const TextLine& m_line;
    std::string_view m_rest;
    const std::string& m_file_name;
    size_t m_data = 8;
};

std::string gsi_name(std::string_view data) {
    const std::string_view name = trimmed(data);
    const size_t start = name.find_first_not_of('0');
    return start == std::string_view::npos ? "0" : std::string(name.substr(start));
}

/// What an instrument recorded on a line: an observation, a station, or both.
struct GsiPolarLine {
    std::string name;
    std::optional<double> direction;
    std::optional<double> zenith;
    std::optional<double> distance;
    std::optional<double> height;   ///< of the prism
    std::array<double, 3> place{};  ///< of the station
    bool is_station = false;

    [[nodiscard]] bool is_observation() const { return direction && zenith && distance; }
    [[nodiscard]] bool observes_some() const { return direction || zenith || distance; }
};

GsiPolarLine polar_line(GsiLine& words) {
    GsiPolarLine line;
    bool is_feet = false;
    while (const auto word = words.next()) {
        if (word->index == 11) {
            line.name = gsi_name(word->data);
        } else if (word->index == 21 || word->index == 22) {
            (word->index == 21 ? line.direction : line.zenith) = words.angle(*word);
        } else if (word->index == 31) {
            line.distance = words.length(*word, is_feet);
        } else if (word->index >= 84 && word->index <= 86) {
            line.place[static_cast<size_t>(word->index - 84)] = words.length(*word, is_feet);
            line.is_station = true;
        } else if (word->index == 87) {
            line.height = words.length(*word, is_feet);
        }
        line.is_station = line.is_station || word->index == 88;
    }
    return line;
}

/// Stations and their observations. A line with a station and no observation begins a new one.
/// Lines of observations may each repeat their station; it is new where its place differs.
ForeignSurvey read_gsi_observations(const std::string& text, const std::string& file_name) {
    ForeignSurvey result{.format = "angles and distances in Leica GSI"};
    PolarSurvey& survey = result.polar;
    std::optional<PolarStation> next_station;
    std::optional<std::array<double, 3>> last_place;
    double kept_height = 0.0;  // until another is given
    for (const TextLine& text_line : lines_of(text, file_name)) {
        GsiLine words(text_line, file_name);
        const GsiPolarLine line = polar_line(words);
        if (line.is_station && (!line.observes_some() || line.place != last_place)) {
            next_station = {.name = line.observes_some() ? "" : line.name,
                            .line = text_line.number};
            last_place = line.place;
        }
        if (!line.is_observation()) {
            if (line.observes_some()) {
                result.left_out.push_back(
                    {.line = text_line.number, .reason = "not all three of the words 21, 22, 31"});
            } else if (line.height) {
                kept_height = *line.height;
            }
            continue;
        }
        if (survey.stations.empty() && !next_station) {
            next_station = {.name = "", .line = text_line.number};
        }
        if (next_station) {
            if (next_station->name.empty()) {
                next_station->name = std::to_string(survey.stations.size() + 1);
            }
            survey.stations.push_back(*std::exchange(next_station, std::nullopt));
        }
        survey.observations.push_back(
            in_first_face({.station = static_cast<int>(survey.stations.size()) - 1,
                           .target = line.name,
                           .direction = *line.direction,
                           .zenith = *line.zenith,
                           .distance = *line.distance,
                           .target_height = line.height.value_or(kept_height),
                           .line = text_line.number}));
    }
    result.notes.emplace_back(
        "columns: words 21, 22, 31 as direction, zenith angle and slope distance, 87 as height of "
        "the prism, 84 to 86 and 88 as a new station; 11 as id, without leading zeros");
    return result;
}

}  // namespace

ForeignSurvey read_gsi(const std::string& text, const std::string& file_name,
                       const SurveyFileOptions& options) {
    ForeignSurvey survey{.format = "Leica GSI-8", .unit = 1.0};
    std::optional<bool> in_feet;
    int polar = 0;
    for (const TextLine& line : lines_of(text, file_name)) {
        if (trimmed(line.text).empty()) {
            continue;
        }
        GsiLine words(line, file_name);
        if (words.is_long()) {
            survey.format = "Leica GSI-16";
        }
        SurveyPoint point{.line = line.number};
        std::array<bool, 3> has{};
        bool is_polar = false;
        bool is_code = false;
        bool is_station = false;
        while (const auto word = words.next()) {
            if (word->index == 11) {
                point.id = gsi_name(word->data);
            } else if (word->index >= 81 && word->index <= 83) {
                const int k = word->index - 81;
                bool is_feet = false;
                point.position(k) = words.length(*word, is_feet);
                has[k] = true;
                if (in_feet.value_or(is_feet) != is_feet) {
                    words.fail(
                        "has coordinates in feet where others are in metres, expected one "
                        "unit");
                }
                in_feet = is_feet;
            }
            is_polar = is_polar || (word->index >= 21 && word->index <= 33);
            is_code = is_code || (word->index >= 41 && word->index <= 49);
            is_station = is_station || (word->index >= 84 && word->index <= 88);
        }
        if (has[0] && has[1] && has[2]) {
            survey.points.push_back(std::move(point));
            continue;
        }
        polar += is_polar ? 1 : 0;
        const bool has_some = has[0] || has[1] || has[2];
        survey.left_out.push_back({.line = line.number,
                                   .reason = has_some   ? "not all three of the words 81, 82, 83"
                                             : is_polar ? "angles and distances without coordinates"
                                             : is_station ? "a station"
                                             : is_code    ? "a code"
                                                          : "no coordinates"});
    }
    if ((survey.points.empty() && polar > 0) || options.takes_observations) {
        return read_gsi_observations(text, file_name);
    }
    survey.notes.emplace_back(
        "columns: words 81, 82, 83 (E, N, H) as x, y, z; 11 as id, without "
        "leading zeros");
    return survey;
}

}  // namespace taut
