// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "force_input.hpp"
#include "suggestions.hpp"
#include "survey_input.hpp"
#include "taut/identification/predicted_precision.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut::app {

/// A planned survey and its predicted precision.
struct PredictedSurvey {
    Survey survey;
    LengthPrior prior;
    PredictedPrecision lengths;
    std::optional<MeasurementSuggestions> suggestions;
};

/// @param options with a survey, or a file that only names nodes
/// @param net_file for messages
/// @param with_notes as of print_survey_notes()
/// @throws InputError as read_survey(), and where nodes are hidden and no standard deviation is
/// given
/// @throws NumericalFailure where there is no equilibrium to linearise at
PredictedSurvey precision_of(const CableNet& net, const Equilibrium& nominal,
                             const SurveyOptions& options, const LengthPrior& prior,
                             const Forces& forces, const UncertainOptions& uncertain,
                             const SuggestionOptions& suggestions, const ForceOptions& noise,
                             const std::string& net_file, bool with_notes);

nlohmann::ordered_json to_json(const CableNet& net, const PredictedSurvey& precision,
                               const std::string& file);

/// Lines to be printed.
std::string precision_text(const CableNet& net, const PredictedSurvey& precision,
                           const SurveyOptions& options);

}  // namespace taut::app
