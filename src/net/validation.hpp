// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// Checks the tension laws. If edges refer to them, also checks that `tension_law` and
/// `axial_stiffness` have one entry an edge. @throws NetError
void validate_tension_laws(const CableNetData& data);

/// Checks every other rule that CableNet promises. @throws NetError at the first that is broken.
void validate(const CableNetData& data);

}  // namespace taut
