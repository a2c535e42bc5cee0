// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut::test {

/// 0, 1, ..., m - 1.
inline std::vector<int> all_edges(const CableNet& net) {
    std::vector<int> edges(net.edge_count());
    std::iota(edges.begin(), edges.end(), 0);
    return edges;
}

}  // namespace taut::test
