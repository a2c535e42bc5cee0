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
#include "taut/adjustment/tension_target.hpp"

/// Options of the commands that plan turns. What their values must keep to, the library checks.
namespace taut::app {

inline constexpr const char* actuator_help =
    "Standard deviation of a stroke as made from the stroke as planned";

/// "1.5kN..10kN[@GROUP]", "20%..60%[@GROUP]"; either end may be left out.
/// @throws std::invalid_argument
[[nodiscard]] TensionRange parse_tension_range(const std::string& text);

/// "20kN[@GROUP]".
/// @throws std::invalid_argument
[[nodiscard]] ReactionBound parse_reaction_bound(const std::string& text);

/// "12kN[:5%|:300N][@GROUP]".
/// @throws std::invalid_argument
[[nodiscard]] GivenTension parse_target_tension(const std::string& text);

/// Stages "ridge:50%,valley,ridge": GROUP or GROUP:PART, one after the other.
/// @throws std::invalid_argument for another text
[[nodiscard]] std::vector<GivenStage> parse_stages(const std::string& text);

/// "normal:1,tangential:0.1"; what is not named has its default.
/// @throws std::invalid_argument
[[nodiscard]] DeviationWeights parse_weights(const std::string& text);

/// --turn 5mm, and --step 1/4 or 0.25, a part of a turn.
/// @param step_help of --step
void add_turn_options(CLI::App& command, std::optional<TurnSize>& turn,
                      const std::string& step_help);

}  // namespace taut::app
