// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "taut/survey/survey.hpp"

namespace taut::app {

/// How a survey file is to be read.
struct SurveyOptions {
    std::string survey;
    std::string frame = "auto";
    std::string control;
    std::string noise;
};

/// --noise, --frame, --control.
std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options);

/// A survey brought to the nodes of a net.
/// @throws InputError naming the file and the line
Survey read_survey(const CableNet& net, const SurveyOptions& options);

/// The same, or where the file names nodes alone, their survey as planned: without places.
/// @throws InputError as read_survey()
Survey read_planned_survey(const CableNet& net, const SurveyOptions& options);

/// Whether any surveyed coordinate has noise.
bool is_noisy(const Survey& survey);

/// What a survey with hidden nodes is expected to hold.
inline constexpr const char* all_or_their_noise =
    "all, or their noise (--noise, or sx, sy, sz in the file)";

/// A form that holds every free node of the net, in its frame (3 x n) [m].
/// @throws InputError naming the file and the line
Points read_form(const CableNet& net, const std::string& file);

/// @param expected what the file should have held
/// @throws InputError where a free node was not surveyed
void refuse_hidden_nodes(const CableNet& net, const Survey& survey, const std::string& file,
                         const std::string& expected);

/// What was read: targets, frame with its residuals, points on no node.
std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey);

/// A length of at least 0, of an option; empty is 0 [m].
/// @throws std::invalid_argument
double parse_noise(const std::string& text);

}  // namespace taut::app
