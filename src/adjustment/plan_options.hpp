// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/plan.hpp"

namespace taut {

/// What plan_strokes() requires of its options and of the posterior samples.
/// @param edges to turn
/// @throws std::invalid_argument, RequestError as plan_strokes()
void check_plan_options(const BuiltNet& built, const PlanOptions& options,
                        const std::vector<int>& edges);

}  // namespace taut
