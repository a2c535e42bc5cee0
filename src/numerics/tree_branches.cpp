// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/tree_branches.hpp"

#include <algorithm>

namespace taut {
namespace {

/// A branch has at most this share of the work, unless the share is less than some milliseconds
/// [multiplications].
constexpr double branch_count = 32.0;
constexpr double least_work = 2e6;

double work_of(const Supernode& supernode) {
    const auto p = static_cast<double>(supernode.size);
    const double size = p + static_cast<double>(supernode.rows.size());
    return p * size * size;
}

}  // namespace

TreeBranches branches_of(const std::vector<Supernode>& supernodes) {
    const int count = static_cast<int>(supernodes.size());
    std::vector<double> work;  // of the subtree of each supernode
    std::vector<int> first;    // supernode of the subtree
    double total = 0.0;
    for (int j = 0; j < count; ++j) {
        work.push_back(work_of(supernodes[j]));
        first.push_back(j);
        for (const int child : supernodes[j].children) {
            work.back() += work[child];
            first.back() = std::min(first.back(), first[child]);
        }
        total += supernodes[j].parent < 0 ? work.back() : 0.0;
    }
    const double most = std::max(total / branch_count, least_work);
    TreeBranches result;
    for (int j = 0; j < count; ++j) {
        const int parent = supernodes[j].parent;
        if (work[j] > most) {
            result.trunk.push_back(j);
        } else if (parent < 0 || work[parent] > most) {
            result.branches.push_back({.first = first[j], .end = j + 1});
        }
    }
    return result;
}

}  // namespace taut
