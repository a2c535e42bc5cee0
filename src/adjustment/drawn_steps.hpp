// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/stroke_search.hpp"

namespace taut {

/// With which confidence limits are to hold over draws.
struct DrawnLimits {
    double confidence = 0.95;
    /// Exact equilibria of the draws at a state.
    std::function<DrawnStrokes(const StrokedState&)> draws;
};

/// Moves strokes by whole steps, one or two at a time, until limits hold over the draws or no move
/// brings them nearer to hold. Draws follow a step by the tangent of the estimate; exact equilibria
/// of all decide. docs/theory.md (whole-steps).
/// @param responses with the limits as given
/// @param start in whole steps
[[nodiscard]] StrokedState steps_holding_draws(std::vector<LimitedResponse>& responses,
                                               const StrokeTask& task, const StrokedState& start,
                                               double step, const DrawnLimits& limits);

}  // namespace taut
