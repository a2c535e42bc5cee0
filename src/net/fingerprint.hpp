// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// CableNet::fingerprint() of the data of a valid net.
[[nodiscard]] std::string compute_fingerprint(const CableNetData& data);

}  // namespace taut
