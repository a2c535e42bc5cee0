// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>

namespace taut {

/// Calls function(begin, size) in parallel for parts of first .. end: rows or columns of a large
/// product that are made at once. The parts do not depend on the number of threads.
template <typename Function>
void by_parts(Eigen::Index first, Eigen::Index end, const Function& function) {
    constexpr Eigen::Index part_size = 128;
    if (end - first <= part_size) {
        if (first < end) {
            function(first, end - first);
        }
        return;
    }
    const Eigen::Index parts = (end - first + part_size - 1) / part_size;
    tbb::parallel_for(Eigen::Index{0}, parts, [&](Eigen::Index part) {
        const Eigen::Index from = first + part * part_size;
        function(from, std::min(part_size, end - from));
    });
}

}  // namespace taut
