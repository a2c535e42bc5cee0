// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "adjustment/stroke_search.hpp"

namespace taut {

/// Brings strokes to whole multiples of a step within their limits: those nearest to one are fixed
/// first and the others sought anew, a quarter at a time; then single steps either way as long as
/// one helps. Exact equilibrium after each. docs/theory.md (whole-steps).
[[nodiscard]] StrokedState in_whole_steps(std::vector<LimitedResponse>& responses,
                                          const StrokeTask& task, const StrokedState& free,
                                          double step);

}  // namespace taut
