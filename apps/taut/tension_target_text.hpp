// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/results/plan_files.hpp"

namespace taut::app {

/// Prints the target tensions, the worst first, and what is in the way of those missed.
void print_tension_targets(const PlanRecord& record);

}  // namespace taut::app
