// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The same form and loads with axial stiffnesses and tensions so many times as large: strains
/// change by tension_factor / stiffness_factor.
/// @param net in equilibrium at its nodes; with loads only at tension_factor 1
/// @throws std::invalid_argument for factors that are not positive and finite
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT CableNet with_strains(const CableNet& net,
                                                           double stiffness_factor,
                                                           double tension_factor);

/// A net of hypar()'s topology that hangs from supports at one height, a dome upside down: tensions
/// come from its loads alone.
/// @param rows, columns as hypar()
/// @param force_density of every edge, positive [N/m]
/// @param weight at every free node, positive [N]
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT CableNet hanging_net(int rows, int columns,
                                                          double force_density, double weight);

/// Nets for trials of whether identifications settle: soft and stiff, with much prestress, with
/// little and with none but that of loads, of 25 to 400 free nodes. Each in equilibrium at its
/// nodes.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::vector<CableNet> settling_nets();

}  // namespace taut
