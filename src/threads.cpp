// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/threads.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "numerics/parallel.hpp"

namespace taut {

void with_threads(int threads, const std::function<void()>& work) {
    if (threads < 1) {
        throw std::invalid_argument(fmt::format("{} threads, expected at least 1", threads));
    }
    limit_threads(threads, work);
}

int max_threads() {
    return arena_size();
}

}  // namespace taut
