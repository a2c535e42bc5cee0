// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The tension of an edge, measured by a load cell or a tension meter.
struct ForceMeasurement {
    int edge = 0;          ///< index in the net
    double tension = 0.0;  ///< [N]
    double std = 0.0;      ///< standard deviation of the measurement [N]
};

/// What is known of the forces of a built net besides its form.
struct Forces {
    std::vector<ForceMeasurement> measurements = {};  ///< of any edges, one an edge
    std::vector<int> taut = {};                       ///< edges seen to carry tension
    std::vector<int> slack = {};                      ///< edges seen to carry none

    /// Whether nothing was measured or seen.
    [[nodiscard]] bool empty() const {
        return measurements.empty() && taut.empty() && slack.empty();
    }
};

/// Whether these can be forces of a net.
/// @throws std::invalid_argument for an edge that is out of range or comes twice, a tension that
///   is negative or not finite, a standard deviation that is not positive and finite, an edge seen
///   both taut and slack, and a measurement of an edge seen slack
TAUT_CORE_EXPORT void check_forces(const CableNet& net, const Forces& forces);

}  // namespace taut
