// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "force_input.hpp"
#include "taut/identification/suggested_measurements.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::app {

/// --suggest, --cost, --load of inspect; with them go --frequency-noise and --free-length-std.
struct SuggestionOptions {
    std::string quantity;  ///< empty: nothing is to be suggested
    std::vector<std::string> costs;
    std::string load;

    /// @throws std::invalid_argument for a word or number that is none
    /// @param forces for the noise of frequencies and free lengths
    [[nodiscard]] SuggestOptions read(const ForceOptions& forces) const;
};

/// @return the options, which need a survey
std::vector<CLI::Option*> add_suggestion_options(CLI::App& command, SuggestionOptions& options,
                                                 ForceOptions& forces);

nlohmann::ordered_json to_json(const CableNet& net, const MeasurementSuggestions& suggestions);

/// Lines to be printed.
std::string suggestions_text(const CableNet& net, const MeasurementSuggestions& suggestions);

}  // namespace taut::app
