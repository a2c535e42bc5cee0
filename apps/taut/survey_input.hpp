// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "taut/files/input_error.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/survey/survey.hpp"

namespace taut::app {

/// --noise, --frame, --control and what is told of the survey's file, as they were told.
struct SurveyOptions {
    std::string survey;
    std::string frame = "auto";
    std::string control;
    std::string noise;
    std::string format;
    std::string unit;
    std::string columns;
    std::string separator;
    std::string decimal;
    std::string encoding;
    std::string match = "auto";
    std::string angle;
    std::string range;
    std::string offset;
    std::string offsets;  ///< table of them
    std::string names;    ///< table to write of points and their nodes

    /// @throws std::invalid_argument as parse_noise(), parse_survey_columns(), parse_angle_std()
    /// and
    ///   parse_distance_precision()
    [[nodiscard]] ReadSurveyOptions reading() const;
};

/// --noise, --frame, --control; --format, --unit, --columns, --separator, --decimal, --encoding;
/// --match, --offset, --offsets, --names; --angle, --range.
std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options);

/// Does something with a survey; a rule of surveys that it breaks is told with the name of its
/// file.
template <class Action>
auto with_survey_of(const std::string& file, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw InputError(file, "", error.what());
    }
}

/// Warnings, and with JSON on standard output how the file was understood, on standard error.
void tell_of_survey(const SurveyOptions& options, const Survey& survey, bool with_notes);

/// What was read: how the file was understood, targets, frame with its residuals, points on no
/// node.
std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey);

/// Of --noise: its scale is to be found from the survey.
inline constexpr std::string_view estimated_noise = "estimate";

/// A length of at least 0, of an option; empty is 0 [m].
/// @throws std::invalid_argument
double parse_noise(const std::string& text);

/// A standard deviation above 0, of --angle.
/// @throws std::invalid_argument
AngleText parse_angle_std(const std::string& text);

}  // namespace taut::app
