// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Points of which each name stands once, and what was averaged, a line for people.
struct AveragedPoints {
    std::vector<SurveyPoint> points;
    std::string note;  ///< empty: no name came twice
};

/// Replaces points of one name by their mean, at the place of the first. Standard deviations
/// become those of the mean, sqrt(sum s_i^2) / n; a mean of points without stays without.
/// @param noise_std of points without standard deviations of their own [m]
/// @throws SurveyError with the line of a point farther than 20 mm, and than 10 standard
///   deviations, from the first of its name
[[nodiscard]] TAUT_CORE_EXPORT AveragedPoints average_repeated(std::vector<SurveyPoint> points,
                                                               double noise_std);

}  // namespace taut
