// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The form in which edges of given force densities balance each other and the loads (Schek 1974).
/// With fixed force densities q, the balance sum_(s,t) q (r_s - r_t) = p_s is linear in r.
/// @param nodes 3 x n; only the supports' coordinates are used [m]
/// @param supports, edges as in CableNetData
/// @param force_densities q of every edge (m), positive [N/m]
/// @param loads 3 x n, or 3 x 0 for none [N]
/// @return 3 x n, supports included [m]
/// @throws std::invalid_argument for sizes that differ, a node out of range, a support or load that
///   is not finite, a force density that is not positive and finite, a free node that no path of
///   edges joins to a support, and force densities that differ by too many orders of magnitude
[[nodiscard]] TAUT_CORE_EXPORT Points form_from_force_densities(
    const Eigen::Ref<const Points>& nodes, const std::vector<int>& supports,
    const std::vector<Edge>& edges, const Eigen::Ref<const Eigen::VectorXd>& force_densities,
    const Eigen::Ref<const Points>& loads = Points(3, 0));

}  // namespace taut
