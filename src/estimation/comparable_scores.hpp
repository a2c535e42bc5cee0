// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/net/cable_net.hpp"

namespace taut {

/// Makes tests of targets, lengths and the boundary comparable, whatever their degrees of freedom:
///
///   score = max(0, 1 + (statistic - threshold) / 20),
///
/// above 1 where the statistic is above its threshold, and larger where more of the misfit is
/// explained. docs/theory.md, (score).
[[nodiscard]] double comparable_score(double statistic, double threshold);

/// An error shows in the tests around it, too, so only the largest score of a neighbourhood counts.
/// @param scores the largest of all tests at each node (n)
/// @return the largest at each node and the nodes next to it (n)
[[nodiscard]] Eigen::VectorXd largest_nearby(const CableNet& net, const Eigen::VectorXd& scores);

}  // namespace taut
