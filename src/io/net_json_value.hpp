// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A net in taut's own format as it stands in a JSON file, alone or within another document.
/// @throws InputError as parse_net()
[[nodiscard]] CableNet read_net_value(const JsonValue& root);

}  // namespace taut
