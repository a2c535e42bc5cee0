// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/interchange/net_import.hpp"

namespace taut {

/// The part of a structure that makes a net: without edges between supports and nodes without
/// edges, which are counted. Indices of nodes are those of the smaller structure.
/// @throws InputError where no edge is left, or no node is a support
[[nodiscard]] ImportedStructure select_net(const ImportedStructure& structure,
                                           ImportReport& report);

}  // namespace taut
