// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The step to which the coordinates of a survey are written: the largest power of ten of which 19
/// of 20 are multiples, so that neither zeros left out at their ends nor a few numbers with
/// rounding errors of a program matter.
/// @param points as they stand in the file
/// @param unit of them [m]
/// @return [m]; 0 for steps below 0.05 um, which are no instrument's, for numbers to the last digit
///   of a double, and where there is no point
[[nodiscard]] TAUT_CORE_EXPORT double rounding_step(const std::vector<SurveyPoint>& points,
                                                    double unit);

/// Standard deviation of a number rounded to a step, (rounding) [m].
[[nodiscard]] TAUT_CORE_EXPORT double rounding_std(double step);

/// Of a coordinate that was measured and then rounded: noise and rounding in quadrature. Rounding
/// below a third of the noise is neglected: it adds less than 6 %, and an instrument's noise is
/// known no better. A coordinate given as exact stays exact.
/// @param noise_std as given [m]
/// @param rounding its rounding_std() [m]
[[nodiscard]] TAUT_CORE_EXPORT double noise_with_rounding(double noise_std, double rounding);

}  // namespace taut
