// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// A point that was surveyed on a cable between its ends.
struct SagPoint {
    int edge = 0;                                        ///< index in the net
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
    double std_dev = 0.0;                                ///< of each coordinate [m]
};

/// The force measurements that points on sagging cables amount to, docs/theory.md (sag). A cable
/// hangs below its chord in a parabola, at x of the chord's length l by m g cos(beta) x (l - x) /
/// (2 T). The parabola is fitted to three points or more by weighted least squares, with its ends
/// free: targets at nodes are seldom on the axis of a cable. The mass is that of the net; its error
/// is the uncertain parameter "mass".
/// @param form in which the cables hang, for their chords (3 x n) [m]
/// @param points in any order
/// @return one for each edge, in ascending order; tension is that at the middle of the cable
/// @throws std::invalid_argument for an edge out of range or without mass, fewer than three points
///   of one, a point that is not between its ends or a tenth of the chord away from it, a std that
///   is not positive, points whose spread shows no parabola, a sag above a twentieth of the chord,
///   and one below three of its standard deviations: then no tension follows
[[nodiscard]] TAUT_CORE_EXPORT std::vector<ForceMeasurement> tensions_by_sag(
    const CableNet& net, const Points& form, const std::vector<SagPoint>& points);

}  // namespace taut
