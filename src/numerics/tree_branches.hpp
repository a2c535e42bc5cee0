// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/supernodes.hpp"

namespace taut {

/// A subtree: the supernodes first .. end.
struct Branch {
    int first = 0;
    int end = 0;
};

struct TreeBranches {
    std::vector<Branch> branches;  ///< independent of each other
    std::vector<int> trunk;        ///< all other supernodes, children before parents
};

/// Chooses as branches the largest subtrees that are each a small share of the elimination work:
/// enough for several cores, none so small that scheduling costs more than the work.
/// @param supernodes children before parents, depth first
[[nodiscard]] TreeBranches branches_of(const std::vector<Supernode>& supernodes);

}  // namespace taut
