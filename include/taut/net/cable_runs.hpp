// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Runs of cable: edges cut one after another from one cable, which passes through the nodes
/// between them. These are CableNetData::runs. If the net gives none, edges are joined that
/// continue each other through a free node of the nominal form with a turn of less than 30 degrees:
/// the straightest pairs first, each edge in at most one pair at a node.
/// @return the runs of the net; or runs of at least two edges each, sorted by their first edge. No
///   edge is in two runs
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::vector<int>> cable_runs(const CableNet& net);

/// Refuses a net whose runs slide, for what does not know how lengths pass on.
/// @param what that is, for the message: "training"
/// @throws NetError naming the first run that does
TAUT_CORE_EXPORT void refuse_sliding(const CableNet& net, std::string_view what);

}  // namespace taut
