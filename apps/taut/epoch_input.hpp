// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "survey_input.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::app {

/// --epoch, as given.
struct EpochFiles {
    std::string survey;
    std::string turned;  ///< empty: nothing was turned
    std::string loads;   ///< empty: nothing was hung on the net
};

void add_epoch_option(CLI::App& command, std::vector<EpochFiles>& epochs);

/// The first survey and those of --epoch.
/// @param with_notes whether to print what was read on standard error
[[nodiscard]] std::vector<Epoch> read_epochs(const CableNet& net, const Survey& first,
                                             const std::vector<EpochFiles>& later,
                                             const SurveyOptions& options, bool with_notes);

}  // namespace taut::app
