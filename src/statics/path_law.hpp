// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>

#include "taut/net/tension_law.hpp"

namespace taut {

/// A straight part of an edge's tension law on the path of InteriorPoint. It takes w of the edge's
/// elongation e, from 0 to its width W, and there the law gives T_k + c w. All parts of an edge
/// have its tension T, so that
///
///   T = T_k + c w - z + y,   z w = mu,   y (W - w) = mu,   z, y >= 0:
///
/// below T_k the part does not stretch (z), and at W it does not stretch further (y). The first
/// part has no z, and the last has neither W nor y; a linear edge is one part with neither.
struct PathPart {
    double begin;  ///< T_k [N]
    double axial;  ///< c; 0 if the law is flat [N/m]
    bool has_low;
    bool has_high;
    double stretch;     ///< w [m]
    double room = 0.0;  ///< W - w > 0 [m]
    double low = 0.0;   ///< z [N]
    double high = 0.0;  ///< y [N]

    double low_wanted = 0.0;   ///< change of z w that the direction aims at [N m]
    double high_wanted = 0.0;  ///< of y (W - w) [N m]
    double stretch_rate = 0.0;
    double low_rate = 0.0;
    double high_rate = 0.0;
};

/// Change of an edge's elongation to first order: de = flexibility dT + drift.
struct PathTangent {
    double flexibility;  ///< [m/N]
    double drift;        ///< [m]
};

/// Number of parts of an edge: that of its law, or 1 if it is linear.
[[nodiscard]] size_t part_count(const TensionLaw* law);

/// Sets the parts to the point of the path with T s = mu, s = e - stretch, at a stretch l - l_0.
/// @param axial of a linear edge, EA / l_0 [N/m]
/// @return T [N]
[[nodiscard]] double start_parts(const TensionLaw* law, double axial, double unstressed,
                                 double stretch, double mu, std::span<PathPart> parts);

/// e, the sum of w [m].
[[nodiscard]] double elongation(std::span<const PathPart> parts);

/// Aims at z w = y (W - w) = mu.
void aim_parts(std::span<PathPart> parts, double mu);
/// Subtracts the second-order change of z w and y (W - w) along the last direction.
void correct_parts(std::span<PathPart> parts);
[[nodiscard]] PathTangent tangent_of(std::span<const PathPart> parts, double tension);
/// Sets the direction of the parts from that of the tension.
void find_part_rates(std::span<PathPart> parts, double tension, double tension_rate);
/// The longest step, at most `step`, that leaves `part_kept` of all quantities that stay positive.
[[nodiscard]] double limit_step(std::span<const PathPart> parts, double part_kept, double step);
void move_parts(std::span<PathPart> parts, double step);

/// Sum and number of the products z w and y (W - w).
struct PathProducts {
    double sum;
    int count;
};
/// After a step along the direction.
[[nodiscard]] PathProducts products_after(std::span<const PathPart> parts, double step);

}  // namespace taut
