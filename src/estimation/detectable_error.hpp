// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace taut {

/// The probability of DetectableErrors.
inline constexpr double detection_power = 0.8;

/// Effect of an error on the statistic of one test, chi-squared of one or three degrees of freedom.
struct TestedItem {
    /// Noncentrality per squared error, k x k for an error of k coordinates [1/m2].
    Eigen::MatrixXd noncentrality;
};

/// The error in a random direction of a random item that raises its statistic above the threshold
/// with detection_power; infinite where none does. docs/theory.md, (detectable)
/// @param degrees_of_freedom of each statistic: 1 or 3
[[nodiscard]] double detectable_error(const std::vector<TestedItem>& items, double threshold,
                                      int degrees_of_freedom);

/// A normal estimate that is rejected outside a bound on either side.
struct BoundedEstimate {
    double bound = 0.0;
    double std_dev = 0.0;
};

/// The same for errors of estimates.
[[nodiscard]] double detectable_error(const std::vector<BoundedEstimate>& estimates);

}  // namespace taut
