// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "survey_input.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::app {

/// Prints a result: its checks, what was assumed, form, tensions, the largest deviations.
/// @param options of the survey
void print_identification(const CableNet& net, const SurveyOptions& options, const Survey& survey,
                          const Identification& result);

}  // namespace taut::app
