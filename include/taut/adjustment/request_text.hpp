// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/adjustment/tension_target.hpp"
#include "taut/export/adjustment.hpp"

/// Parts of a request as text, as the program takes them. What they must keep to, plan_turns()
/// checks.
namespace taut {

/// "1.5kN..10kN[@GROUP]", "20%..60%[@GROUP]"; either end may be left out.
/// @throws RequestError for another text, std::invalid_argument for another force or part
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT TensionRange parse_tension_range(const std::string& text);

/// "20kN[@GROUP]".
/// @throws std::invalid_argument
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ReactionBound parse_reaction_bound(const std::string& text);

/// "12kN[:5%|:300N][@GROUP]".
/// @throws std::invalid_argument
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT GivenTension parse_target_tension(const std::string& text);

/// Stages "ridge:50%,valley,ridge": GROUP or GROUP:PART, one after the other.
/// @throws RequestError for another text, std::invalid_argument for another part
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<GivenStage> parse_stages(const std::string& text);

/// "normal:1,tangential:0.1"; what is not named has its default.
/// @throws RequestError for another text
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT DeviationWeights parse_weights(const std::string& text);

/// "1/4" or "0.25": a part of a turn.
/// @throws RequestError for another text
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT double parse_part_of_turn(const std::string& text);

}  // namespace taut
