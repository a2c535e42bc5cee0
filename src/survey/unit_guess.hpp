// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A unit that coordinates may be in.
struct UnitGuess {
    const char* name;  ///< "mm"
    double length;     ///< [m]
    double points;     ///< extent of the points, in their own unit
    double nodes;      ///< extent of the nodes that they are of [m]
};

/// The unit of m, mm and ft in which the points extend as far as the net, to a factor of 1.8. Their
/// extent is the median distance from their middle, the coordinates' medians, so that a few points
/// elsewhere do not matter. Points with names of nodes are compared with these, else with all.
/// @return nothing where none of the units fits
[[nodiscard]] TAUT_CORE_EXPORT std::optional<UnitGuess> guess_unit(
    const CableNet& net, const std::vector<SurveyPoint>& points);

/// The same extents, whatever the unit: for a message.
[[nodiscard]] TAUT_CORE_EXPORT std::string extents_text(const CableNet& net,
                                                        const std::vector<SurveyPoint>& points);

}  // namespace taut
