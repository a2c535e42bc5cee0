// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/explanation.hpp"

namespace taut {

/// What else may explain what was found: each returns the explanation of the lowest cost, perhaps
/// the one that it was given. docs/theory.md, (boundary), (slip).

/// Outliers of the boundary released, first all at once, then one after another. Gross errors
/// elsewhere show at the boundary, too, and several boundary outliers show at many targets: hence
/// both orders are tried.
[[nodiscard]] Explanation with_boundary(const FitProblem& problem, Explanation found);

/// An edge that is much too short pulls its run, and seems slack at the length that is expected of
/// it. So edges that are slack where nothing is released, and those from the nodes of what was
/// found to supports, are tried one by one, taut and instead of what was found; then others beside
/// that.
[[nodiscard]] Explanation with_taut_edges(const FitProblem& problem, Explanation found);

/// A slipped clamp at each suspect node. Where clamp and target cost nearly the same, the survey
/// does not separate them: the target is left out and both edges get wide priors.
[[nodiscard]] Explanation with_clamps(const FitProblem& problem, Explanation found);

}  // namespace taut
