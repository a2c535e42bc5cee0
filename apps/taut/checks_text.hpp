// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/estimation/detectable.hpp"
#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"

namespace taut::app {

/// Prints what the checks found, the worst first, and the smallest errors that they find.
void print_checks(const Trust& trust, const DetectableErrors& detectable);

/// Prints the uncertain parameters, and how to change them.
void print_assumptions(const Identification& result);

}  // namespace taut::app
