// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "taut/survey/survey.hpp"

namespace taut {

/// The node that a target lies on, or why none.
struct PlaceMatch {
    int node = 0;           ///< nearest
    double distance = 0.0;  ///< to its nominal place [m]
    std::optional<UnmatchedReason> unmatched;
};

/// Matches targets to nodes, supports included, by their places alone, one to one: a target is
/// put on its nearest node where it lies within half the mean edge length, is twice as near to it
/// as to any other, and no other target claims it. All else is left unmatched rather than guessed.
/// @param taken nodes that other points were put on
[[nodiscard]] std::vector<PlaceMatch> match_by_place(const CableNet& net,
                                                     const std::vector<SurveyPoint>& targets,
                                                     const std::function<bool(int)>& taken);

}  // namespace taut
