// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/adjustment/limits.hpp"

namespace taut {

/// The nodes of all reaction limits, in their order.
[[nodiscard]] std::vector<int> supports_of(const std::vector<ReactionLimit>& reactions);

/// Limits of all tensions, then of the reactions.
[[nodiscard]] ForceRange range_of(const CableNet& net, const TensionLimits& tension,
                                  const std::vector<ReactionLimit>& reactions);

/// The net with other loads.
[[nodiscard]] CableNet with_loads(const CableNet& net, const Points& loads);

}  // namespace taut
