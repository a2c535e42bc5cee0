// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Why a survey does not fit the net, and what to do: it is mirrored (x and y exchanged, an axis
/// negated), in another unit, of another scale, in another frame, or in two units. Points with
/// names of nodes are fitted to these, mirrored or not, at any scale; points without names are
/// counted by match_by_place().
/// @param points as the file has them [m]
/// @param unit that their numbers were taken in [m]
/// @param frame_is_fitted whether their frame may be any
/// @return "; ..." or nothing
[[nodiscard]] TAUT_CORE_EXPORT std::string misfit_hint(const CableNet& net,
                                                       const std::vector<SurveyPoint>& points,
                                                       double unit = 1.0,
                                                       bool frame_is_fitted = false);

}  // namespace taut
