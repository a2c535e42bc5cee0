// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace taut {

/// What one more target tells.
struct SurveyGain {
    int place = 0;           ///< of the node, among those of the draws
    double left_over = 0.0;  ///< root of the mean variance after this target and those before
};

/// The targets that tell most of numbers that are known by draws, one after the other: each lowers
/// the mean variance of the numbers by the most, given those before, with the noise that it would
/// be seen with. To first order: by the covariances of the draws. docs/theory.md, (survey-gain).
/// Ends before `most` where no target tells more than chance would make of so many draws.
/// @param forms coordinates of the places, three rows each, one draw a column [m]
/// @param numbers one a row, of the same draws
/// @param noise_std of each coordinate, positive [m]
[[nodiscard]] std::vector<SurveyGain> gains_of_targets(const Eigen::MatrixXd& forms,
                                                       const Eigen::MatrixXd& numbers,
                                                       double noise_std, int most);

}  // namespace taut
