// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Whether points lie on other nodes than those of their names, as where a surveyor counts from 1:
/// at least a part of the points is matched by match_by_place(), and less than half of these to the
/// node of their name.
/// @param matched_part that part: 0.95 to rely on it, less to guess
[[nodiscard]] TAUT_CORE_EXPORT bool names_contradict_places(const CableNet& net,
                                                            const std::vector<SurveyPoint>& points,
                                                            double matched_part = 0.95);

/// Turns names into labels, so that those points are matched by their place.
/// @param all of them, or only those that are no node's
/// @return how many
TAUT_CORE_EXPORT int make_names_labels(const CableNet& net, std::vector<SurveyPoint>& points,
                                       bool all);

}  // namespace taut
