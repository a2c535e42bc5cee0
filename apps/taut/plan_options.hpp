// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "taut/adjustment/plan.hpp"

namespace taut::app {

/// --turn 5mm --step 1/4; nothing where no turn is told.
/// @throws std::invalid_argument
std::optional<TurnSize> parse_turn(const std::string& turn, const std::string& step);

/// "1.5kN..10kN", of which either end may be left out: least and most, infinite where there is none
/// [N].
/// @throws std::invalid_argument for anything else, a least below 0 or not below the most
std::pair<double, double> parse_tension_range(const std::string& text);

}  // namespace taut::app
