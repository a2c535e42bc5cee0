// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// Where a run slides: each node of slides_at between two edges that follow each other in its list.
[[nodiscard]] std::vector<SlidingNode> sliding_nodes_of(const std::vector<Edge>& edges,
                                                        const CableRun& run);

/// Edges of each stretch of cable that slides, from one clamp to the next, edge by edge.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::vector<int>> sliding_stretches(const CableNet& net);

/// The edges of the stretch that an edge slides in; the edge alone where it does not.
[[nodiscard]] std::vector<int> stretch_of(const CableNet& net, int edge);

/// Whether each edge is one of a stretch (m).
[[nodiscard]] std::vector<bool> edges_that_slide(const CableNet& net);

/// The same net, with its runs clamped where they are.
[[nodiscard]] CableNet clamped(const CableNet& net);

}  // namespace taut
