// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "adjustment/drawn_forces.hpp"
#include "adjustment/stroke_search.hpp"

namespace taut {

/// The required probability of keeping limits, and the samples to count it in.
struct DrawnLimits {
    double confidence = 0.95;
    /// Exact equilibria of the samples at a state.
    std::function<DrawnStrokes(const StrokedState&)> draws;
};

/// Moves strokes by whole steps, one or two at a time, until limits are kept with the required
/// probability or no move helps. Moves are ranked by the tangent of the estimate; exact equilibria
/// of all samples decide. docs/theory.md (whole-steps).
/// @param responses with the limits as given
/// @param start in whole steps
[[nodiscard]] StrokedState steps_holding_draws(std::vector<LimitedResponse>& responses,
                                               const StrokeTask& task, const StrokedState& start,
                                               double step, const DrawnLimits& limits);

}  // namespace taut
