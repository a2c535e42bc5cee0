// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/load_check.hpp"

#include <cmath>

namespace taut {

bool LoadCheck::is_missing() const {
    return std_dev > 0.0 && std::abs(force) > significant_std * std_dev;
}

LoadCheck check_loads(const LinearisedFit& fitted, double scale) {
    const CableNet& net = fitted.model().net();
    Points loads = Points::Zero(3, net.node_count());
    for (const int node : net.free_nodes()) {
        loads(2, node) = -1.0;
    }
    const Linearisation::Score score = fitted.linearisation.score_of_loads(loads);
    const double information = score.information(0, 0);
    if (!(information > 0.0)) {
        return {};
    }
    return {.force = score.gradient(0) / information, .std_dev = std::sqrt(scale / information)};
}

}  // namespace taut
