// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What was turned at an adjustable edge.
struct EdgeTurned {
    int edge = 0;          ///< index of an adjustable edge
    double stroke = 0.0;   ///< change of its unstressed length [m]
    double std_dev = 0.0;  ///< standard deviation of that; 0: exact [m]
};

/// No turnbuckle changes its edge by a larger part of the unstressed length.
inline constexpr double most_turned_part = 0.25;

/// Whether this can have been turned at a net.
/// @throws std::invalid_argument for an edge that is not adjustable or comes twice, a stroke that
///   is not finite or more than most_turned_part of the edge, and a std that is negative, not
///   finite or more than that
TAUT_CORE_EXPORT void check_turned(const CableNet& net, std::span<const EdgeTurned> turned);

/// All that was turned in one step after another: one entry an edge, ascending; variances add up.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<EdgeTurned> all_turned(
    std::span<const std::vector<EdgeTurned>> steps);

/// The net with these lengths; its nodes where they were. An edge may come twice.
/// @param turned edges of the net, which is not checked: check_turned() does
/// @throws NetError for a length that is no longer positive
[[nodiscard]] TAUT_CORE_EXPORT CableNet turned_net(const CableNet& net,
                                                   std::span<const EdgeTurned> turned);

}  // namespace taut
