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

/// The options of add_survey_options().
struct SurveyOptions {
    ReadSurveyOptions read;  ///< but for what stands below
    std::string survey;
    std::string control;
    std::string noise;    ///< a length, or estimated_noise
    std::string offsets;  ///< file of a table
    std::string names;    ///< file to write: points and their nodes

    /// @throws std::invalid_argument as parse_noise()
    /// @throws InputError as parse_target_offsets()
    [[nodiscard]] ReadSurveyOptions read_options() const;
};

/// --noise, --frame, --control; --format, --unit, --columns, --separator, --decimal, --encoding;
/// --match, --offset, --offsets, --names; --angle, --range. --noise is among the first of the help.
/// @return all of them
std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options);

/// Does something with a survey. A SurveyError becomes an InputError that names its file.
template <class Action>
auto with_survey_of(const std::string& file, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw InputError(file, "", error.what());
    }
}

/// Prints the survey's warnings on standard error, and its notes on how the file was understood.
/// @param with_notes where JSON takes standard output, on which survey_text() has them
void print_survey_notes(const SurveyOptions& options, const Survey& survey, bool with_notes);

/// What was read: targets, how the file was understood, coordinate system with its residuals,
/// points at no node.
std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey);

/// Value of --noise: estimate its scale from the survey.
inline constexpr std::string_view estimated_noise = "estimate";

/// A length of at least 0 as --noise gives it; empty is 0 [m].
/// @throws std::invalid_argument
double parse_noise(const std::string& text);

/// A standard deviation above 0 as --angle gives it.
/// @throws std::invalid_argument
AngleText parse_angle_std(const std::string& text);

}  // namespace taut::app
