// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Whether a survey fits better if it is moved or scaled as a whole, docs/theory.md (frame-check).
/// @param scale Hypotheses::residual_scale
[[nodiscard]] FrameCheck check_frame(const LinearisedFit& fitted, const Observations& observations,
                                     double scale);

}  // namespace taut
