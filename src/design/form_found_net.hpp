// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// Distance in plan of neighbouring nodes of the built-in nets [m].
inline constexpr double lattice_spacing = 0.132;

/// A net with the axial stiffness and force density of the built-in nets, in its equilibrium form.
/// @param nodes 3 x n; only the supports' coordinates matter [m]
[[nodiscard]] CableNet form_found_net(std::string name, const Points& nodes,
                                      const std::vector<int>& supports,
                                      const std::vector<Edge>& edges);

}  // namespace taut
