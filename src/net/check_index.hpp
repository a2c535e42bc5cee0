// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace taut {

/// @param what the index is of: "node"
/// @throws std::out_of_range where it is not 0 to count - 1
inline void check_index(std::string_view what, std::ptrdiff_t index, std::ptrdiff_t count) {
    if (index < 0 || index >= count) {
        throw std::out_of_range(
            count == 0 ? fmt::format("{} {}, and there is none", what, index)
                       : fmt::format("{} {}, expected 0 to {}", what, index, count - 1));
    }
}

}  // namespace taut
