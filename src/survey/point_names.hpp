// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/survey/survey.hpp"

namespace taut {

/// Whether the names of points are other ones than the net's although they look alike, as the
/// numbers of a surveyor who counts from 1: six of seven points lie on a node beyond doubt
/// (match_by_place()), and less than half of these on the node of their name.
[[nodiscard]] bool names_contradict_places(const CableNet& net,
                                           const std::vector<SurveyPoint>& points);

/// Turns names into labels, so that those points are matched by their place.
/// @param all of them, or only those that are no node's
/// @return how many
int make_names_labels(const CableNet& net, std::vector<SurveyPoint>& points, bool all);

}  // namespace taut
