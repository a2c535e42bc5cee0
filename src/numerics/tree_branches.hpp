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

/// Takes as branches the largest subtrees that are a small part of the work of elimination each:
/// enough of them for some cores, none so small that handing it over costs more than its work.
///
/// @param supernodes children before parents, depth first
[[nodiscard]] TreeBranches branches_of(const std::vector<Supernode>& supernodes);

}  // namespace taut
