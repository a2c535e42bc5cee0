// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "numerics/parallel.hpp"

namespace taut {

/// Whether the parts of a large product are computed in parallel or one after the other.
enum class Parts { parallel, serial };

/// Calls function(begin, size) for parts of first .. end: rows or columns of a large product. The
/// parts are the same for any number of threads, and for serial work.
template <typename Function>
void by_parts(Parts parts, Eigen::Index first, Eigen::Index end, const Function& function) {
    constexpr Eigen::Index part_size = 128;
    const auto part = [&](Eigen::Index from) { function(from, std::min(part_size, end - from)); };
    if (parts == Parts::serial || end - first <= part_size) {
        for (Eigen::Index from = first; from < end; from += part_size) {
            part(from);
        }
        return;
    }
    const Eigen::Index count = (end - first + part_size - 1) / part_size;
    parallel_for(Eigen::Index{0}, count, [&](Eigen::Index k) { part(first + k * part_size); });
}

}  // namespace taut
