// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/survey/survey.hpp"

namespace taut {

/// What would bring points that do not fit the net to its nodes, to be told with that: x and y
/// exchanged (19 of 20 are then on a node beyond doubt), or some points in another unit than the
/// others (each named point is near its node in m, mm or ft). For points in the net's frame.
/// @return "; ..." or nothing
[[nodiscard]] std::string misfit_hint(const CableNet& net, const std::vector<SurveyPoint>& points);

}  // namespace taut
