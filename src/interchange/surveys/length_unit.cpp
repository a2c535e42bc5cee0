// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "interchange/surveys/survey_reader.hpp"

namespace taut {

std::optional<double> length_of_unit(std::string_view name) {
    // As they stand in headers, and as LandXML names them.
    constexpr double foot = 0.3048;
    constexpr double survey_foot = 1200.0 / 3937.0;
    constexpr auto units = std::to_array<std::pair<std::string_view, double>>({
        {"m", 1.0},
        {"meter", 1.0},
        {"metre", 1.0},
        {"meters", 1.0},
        {"metres", 1.0},
        {"mm", 1e-3},
        {"millimeter", 1e-3},
        {"millimetre", 1e-3},
        {"cm", 1e-2},
        {"centimeter", 1e-2},
        {"centimetre", 1e-2},
        {"dm", 0.1},
        {"kilometer", 1e3},
        {"ft", foot},
        {"foot", foot},
        {"feet", foot},
        {"us-ft", survey_foot},
        {"ussurveyfoot", survey_foot},
        {"usft", survey_foot},
        {"us survey ft", survey_foot},
        {"in", 0.0254},
        {"inch", 0.0254},
        {"inches", 0.0254},
        {"fuss", foot},
    });
    const std::string lower = in_lower_case(trimmed(name));
    for (const auto& [unit, length] : units) {
        if (lower == unit) {
            return length;
        }
    }
    return std::nullopt;
}

}  // namespace taut
