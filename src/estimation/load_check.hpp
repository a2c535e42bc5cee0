// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearisation.hpp"
#include "taut/estimation/diagnostics.hpp"

namespace taut {

/// Whether a survey fits better with one more vertical load at each free node, docs/theory.md
/// (load-check).
/// @param scale Hypotheses::residual_scale
[[nodiscard]] LoadCheck check_loads(const LinearisedFit& fitted, double scale);

}  // namespace taut
