// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace taut {

/// The median of at least one value, of an even number the upper of the two in the middle.
[[nodiscard]] inline double median_of(const Eigen::VectorXd& values) {
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + std::ssize(sorted) / 2;
    std::ranges::nth_element(sorted, middle);
    return *middle;
}

}  // namespace taut
