// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/thinning.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace taut::report {

std::vector<int> thinned(int count, int limit) {
    const double part = static_cast<double>(limit) / count;
    std::vector<int> kept;
    for (int i = 0; i < count; ++i) {
        // The multiples of the golden ratio, less their whole part, fill [0, 1) more evenly than
        // those of any other number, and keep no step with the order of a net.
        const double multiple = std::numbers::phi * i;
        if (multiple - std::floor(multiple) < part) {
            kept.push_back(i);
        }
    }
    return kept;
}

std::string thinning_words(int count, int limit, const std::string& noun) {
    return count <= limit ? ""
                          : fmt::format("{} of {} {}s", thinned(count, limit).size(), count, noun);
}

}  // namespace taut::report
