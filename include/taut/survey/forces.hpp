// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What a tension was measured by.
enum class ForceSource {
    load_cell,  ///< or a tension meter
    frequency,  ///< a natural frequency of the cable
    sag,        ///< of the cable under its own weight
};

/// "load_cell", "frequency", "sag".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(ForceSource source);

/// The tension of an edge, measured by a load cell or a tension meter, or found from a natural
/// frequency or a sag.
struct ForceMeasurement {
    int edge = 0;                                 ///< index in the net
    double tension = 0.0;                         ///< negative in a compressed strut [N]
    double std_dev = 0.0;                         ///< standard deviation of its own error [N]
    ForceSource source = ForceSource::load_cell;  ///< what it was measured by
    int mode = 0;                                 ///< of the frequency; 0 where there is none
    /// Standard deviation of its part in an error that all measurements of its kind share, besides
    /// the relative one of the uncertain parameters "forces" (load cells) and "mass" [N].
    double shared_std = 0.0;

    /// Whether it is as wrong as the mass of the cable.
    [[nodiscard]] bool is_by_mass() const { return source != ForceSource::load_cell; }
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
///   is negative (of a cable) or not finite, a strut seen taut or slack, measured by its frequency
///   or sag, a standard deviation that is not positive and finite, an edge seen
///   both taut and slack, and a measurement of an edge seen slack
TAUT_CORE_EXPORT void check_forces(const CableNet& net, const Forces& forces);

}  // namespace taut
