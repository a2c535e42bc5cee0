// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/threads.hpp"

#include <fmt/core.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

namespace taut {

void with_threads(int threads, const std::function<void()>& work) {
    if (threads < 1) {
        throw std::invalid_argument(fmt::format("{} threads, expected at least 1", threads));
    }
    // An arena allocates memory for each thread, and oneTBB fails for very large numbers.
    tbb::task_arena(std::min(threads, tbb::info::default_concurrency())).execute(work);
}

}  // namespace taut
