// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The smallest eigenvalue of the tangent stiffness of the free nodes, tangent_stiffness(). An
/// equilibrium is stable where it is positive, buckles where it is negative, and is about to where
/// it is small beside that of another form of the net. By bisection with Sylvester's law of
/// inertia, to a thousandth; 0 for what is smaller than 1e-12 of the largest entry.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form coordinates of all nodes (3 x n) [m]
/// @return [N/m]
/// @throws std::invalid_argument for wrong sizes, unstressed lengths that are not positive and
///   finite, coordinates that are not finite
[[nodiscard]] TAUT_CORE_EXPORT double smallest_stiffness(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form);

}  // namespace taut
