// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "adjustment/stroke_search.hpp"

namespace taut {

struct FewestStrokes {
    StrokedState found;
    int bound = 0;  ///< to first order, no fewer edges reach the tolerance
};

/// Few strokes with which the state is_within_tolerances(). A reweighted l1 norm
/// (E. J. Candes, M. B. Wakin, S. P. Boyd, J. Fourier Anal. Appl. 14, 2008) chooses the edges; then
/// each that is not needed is dropped, in exact equilibrium. docs/theory.md (fewest-strokes).
/// @param all a state within the tolerances
[[nodiscard]] FewestStrokes fewest_strokes(std::vector<LimitedResponse>& responses,
                                           const StrokeTask& task, const StrokedState& all);

}  // namespace taut
