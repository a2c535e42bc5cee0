// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// check_limits() without the limits of strokes.
/// @throws std::invalid_argument as check_limits()
void check_force_limits(const CableNet& net, const Limits& limits);

/// Checks that a plan is one of this net under these limits.
/// @throws std::invalid_argument for strokes of an edge that the net does not have, doubled or not
///   finite, and for effective limits of another number of forces or load cases
void check_plan(const CableNet& net, const Limits& limits, const Plan& plan);

}  // namespace taut
