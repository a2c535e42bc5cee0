// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"

namespace taut::app {

/// Prints the estimates of the uncertain parameters: those common to many edges in full; of the
/// others how many the survey determines, and the one that is farthest from the design.
void print_uncertain(const CableNet& net, const Identification& result);

}  // namespace taut::app
