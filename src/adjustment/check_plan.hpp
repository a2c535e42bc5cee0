// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Whether a net can keep to limits of forces: as check_limits(), strokes apart.
/// @throws std::invalid_argument as check_limits()
void check_force_limits(const CableNet& net, const Limits& limits);

/// Whether a plan can be one of a net under limits of forces.
/// @throws std::invalid_argument for strokes of an edge that the net does not have, doubled or not
///   finite, and for limits that it held which are of another number of forces or load cases
void check_plan(const CableNet& net, const Limits& limits, const Plan& plan);

}  // namespace taut
