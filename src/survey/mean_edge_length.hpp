// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// Of the net at its nominal form [m].
[[nodiscard]] inline double mean_edge_length(const CableNet& net) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (net.nodes().col(s) - net.nodes().col(t)).norm();
    }
    return sum / net.edge_count();
}

}  // namespace taut
