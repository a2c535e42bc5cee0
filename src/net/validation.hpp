// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// Checks every rule that CableNet promises. @throws NetError at the first that is broken.
void validate(const CableNetData& data);

}  // namespace taut
