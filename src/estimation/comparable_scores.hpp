// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/net/cable_net.hpp"

namespace taut {

/// By which tests of targets, lengths and the boundary stand against each other: above 1 where the
/// statistic is above its threshold, and larger where more of the misfit is explained, whatever the
/// degrees of freedom. docs/theory.md, (score).
[[nodiscard]] double comparable_score(double statistic, double threshold);

/// What is wrong shows in the tests around it, too, so that only the largest of a neighbourhood is
/// blamed.
/// @param scores of all tests that end or stand at a node, the largest (n)
/// @return the largest at each node and the nodes next to it (n)
[[nodiscard]] Eigen::VectorXd largest_nearby(const CableNet& net, const Eigen::VectorXd& scores);

}  // namespace taut
