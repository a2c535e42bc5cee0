// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/adjustment/request_text.hpp"
#include "taut/adjustment/tension_target.hpp"

/// Options of the commands that plan turns. What their values must keep to, the library checks.
namespace taut::app {

inline constexpr const char* actuator_help =
    "Standard deviation of a stroke as made from the stroke as planned";

/// --turn 5mm, and --step 1/4 or 0.25, a part of a turn.
/// @param step_help of --step
void add_turn_options(CLI::App& command, std::optional<TurnSize>& turn,
                      const std::string& step_help);

}  // namespace taut::app
