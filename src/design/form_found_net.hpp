// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// A net of equal axial stiffness and equal force density, in the form in which it balances.
/// @param nodes 3 x n; only the supports' coordinates matter [m]
/// @param force_density of every edge [N/m]; @param axial_stiffness of every edge [N]
[[nodiscard]] CableNet form_found_net(std::string name, const Points& nodes,
                                      const std::vector<int>& supports,
                                      const std::vector<Edge>& edges, double force_density,
                                      double axial_stiffness);

}  // namespace taut
