// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace taut {

/// A short closed walk over places (3 x n): from each to the nearest not yet visited, then with
/// stretches reversed while that shortens it (2-opt). @return the order of the places
[[nodiscard]] std::vector<int> short_tour(const Eigen::Matrix3Xd& places);

}  // namespace taut
