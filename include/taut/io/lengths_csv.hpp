// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// Lengths of a net as built against those designed, as CSV: the header
/// "edge,nominal,length_deviation" and a row an interior edge, in their order: CableNet::edge_id(),
/// unstressed length as designed, and by how much the built one differs; in metres.
/// @throws std::invalid_argument where the interior edges of the two nets are not the same
[[nodiscard]] std::string lengths_to_csv(const CableNet& nominal, const CableNet& built);

}  // namespace taut
