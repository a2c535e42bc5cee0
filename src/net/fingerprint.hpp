// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// 16 hexadecimal digits of FNV-1a (64 bit) over what makes a net behave as it does.
[[nodiscard]] std::string compute_fingerprint(const CableNetData& data);

}  // namespace taut
