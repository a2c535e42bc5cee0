// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace taut::report {

/// More edges than this would stand closer in a figure than the dots are wide.
inline constexpr int most_edges = 1000;

/// About `limit` of the indices 0, ..., count - 1, ascending and evenly spread, so that a drawing
/// of many things stays small; all of them where they are no more than that. The first is among
/// them. Not every n-th: in the order of a regular net that could be all the edges of one
/// direction.
[[nodiscard]] std::vector<int> thinned(int count, int limit);

/// "6012 of 7080 interior edges"; nothing where all are drawn.
[[nodiscard]] std::string thinning_words(int count, int limit, const std::string& noun);

}  // namespace taut::report
