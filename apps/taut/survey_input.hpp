// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "taut/survey/registration.hpp"
#include "taut/survey/survey.hpp"

namespace taut::app {

/// How a survey file is to be read.
struct SurveyOptions {
    std::string survey;
    std::string frame = "auto";
    std::string control;
    std::string noise;
};

/// SURVEY, --noise, --frame, --control.
void add_survey_options(CLI::App& command, SurveyOptions& options);

/// A survey brought to the nodes of a net, and how it came there.
struct SurveyInput {
    Survey survey;
    std::optional<Registration> registration;  ///< where its frame was not the net's
};

/// @throws InputError naming the file and the line
SurveyInput read_survey(const CableNet& net, const SurveyOptions& options);

/// What was read: targets, frame with its residuals, points on no node.
std::string survey_text(const CableNet& net, const SurveyOptions& options,
                        const SurveyInput& input);

/// A length of at least 0, of an option; empty is 0 [m].
/// @throws std::invalid_argument
double parse_noise(const std::string& text);

}  // namespace taut::app
