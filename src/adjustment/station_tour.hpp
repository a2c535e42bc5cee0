// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace taut {

/// A short closed walk over places (3 x n): from each to the nearest not yet visited, then turned
/// about until no two legs cross (2-opt). @return their order
[[nodiscard]] std::vector<int> short_tour(const Eigen::Matrix3Xd& places);

}  // namespace taut
