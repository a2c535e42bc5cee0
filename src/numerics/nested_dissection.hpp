// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/elimination_order.hpp"

namespace taut {

/// An order of elimination by METIS, the same each time.
/// @return rows, the first to be eliminated first; none where taut was built without METIS
/// @throws std::bad_alloc where memory does not suffice
[[nodiscard]] std::vector<int> nested_dissection(const MatrixGraph& graph);

}  // namespace taut
