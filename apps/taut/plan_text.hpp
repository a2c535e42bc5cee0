// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/adjustment/plan.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/results/plan_files.hpp"

namespace taut::app {

/// Prints a plan: warnings, deviations, strokes, limits, the order of work, suggestions.
void print_plan(const PlanRecord& record);

/// "edge 3 under snow.csv: 12.1 kN, limit 12 kN"
[[nodiscard]] std::string where_text(const CableNet& net, const LimitBreach& breach);

}  // namespace taut::app
