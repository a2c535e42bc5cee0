// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A sentence on nodes at which a net, as given, is not in equilibrium though it is at all others:
/// a cable or a load may be missing there. Empty where the net is in equilibrium, and where many
/// nodes are not, since their places are then a first guess.
[[nodiscard]] std::string net_balance_text(const CableNet& net);

/// The same as a finding: failed where the survey contradicts something near these nodes, for a
/// cable that the net lacks looks as if those beside it were wrong.
/// @param of_all_else the verdict without it
[[nodiscard]] std::optional<Trust::Finding> net_balance_finding(const CableNet& net,
                                                                const Identification& result,
                                                                Trust::Verdict of_all_else);

}  // namespace taut
