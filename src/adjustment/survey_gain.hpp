// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace taut {

/// The gain from surveying one more target.
struct SurveyGain {
    int place = 0;               ///< of the node, among those of the samples
    double remaining_std = 0.0;  ///< root of the mean variance after this target and those before
};

/// The most informative targets for some numbers, one after the other: each lowers the mean
/// variance of the numbers most, given those before. To first order, by the covariances of
/// posterior samples. docs/theory.md, (survey-gain). Ends before `most` where no target explains
/// more than chance would.
/// @param forms coordinates of the places, three rows each, one sample per column [m]
/// @param numbers one per row, of the same samples
/// @param noise_std a-priori standard deviation of each coordinate, positive [m]
[[nodiscard]] std::vector<SurveyGain> gains_of_targets(const Eigen::MatrixXd& forms,
                                                       const Eigen::MatrixXd& numbers,
                                                       double noise_std, int most);

}  // namespace taut
