// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What a survey that does not fit the net is in truth, in words, with what to do: mirrored (x and
/// y exchanged, an axis negated), in another unit, of another scale, in another frame, or of points
/// in two units. Found by fitting the points with names of nodes to these, in either hand and at
/// any scale; of points without names by how many are then on a node beyond doubt
/// (match_by_place()).
/// @param points as the file has them [m]
/// @param unit that their numbers were taken in [m]
/// @param frame_is_fitted whether their frame may be any
/// @return "; ..." or nothing
[[nodiscard]] TAUT_CORE_EXPORT std::string misfit_hint(const CableNet& net,
                                                       const std::vector<SurveyPoint>& points,
                                                       double unit = 1.0,
                                                       bool frame_is_fitted = false);

}  // namespace taut
