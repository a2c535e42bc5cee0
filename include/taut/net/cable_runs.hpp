// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Runs of cable: edges that are cut from one cable, one after another, which passes through the
/// nodes between them. Those of CableNetData::runs; where the net gives none, edges that go
/// straight on through a free node of the nominal form: of each pair there that turns by less than
/// 30 degrees, the straightest first, each edge in one pair at a node.
/// @return as given; or of at least two edges each, in the order of their first. No edge is in two
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::vector<int>> cable_runs(const CableNet& net);

}  // namespace taut
