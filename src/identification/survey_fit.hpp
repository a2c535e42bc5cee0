// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identification/gauss_newton.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// Edges (m) that a form shows to be slack, whatever the survey tells of their lengths: adjustable
/// ones, of known length, that are shorter than it; and interior ones that would be taut only at a
/// deviation beyond three standard deviations of the law (beyond the bound of a uniform one).
[[nodiscard]] std::vector<bool> slack_by_form(const CableNet& net, const Guess& guess,
                                              const LengthLaw& law);

/// Fits form and lengths to what is known, from a start, with the edges named slack that the fitted
/// form shows to be so. The statics are left linearised at the result.
/// @throws std::runtime_error as fit_under_statics()
[[nodiscard]] GaussNewtonResult fit_to_survey(const CableNet& net, ConditionedStatics& statics,
                                              const Knowledge& knowledge, const LengthLaw& law,
                                              Guess start, double tolerance, int max_iterations);

}  // namespace taut
