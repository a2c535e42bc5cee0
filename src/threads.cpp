// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/threads.hpp"

#include <fmt/core.h>
#include <tbb/task_arena.h>

#include <stdexcept>

namespace taut {

void with_threads(int threads, const std::function<void()>& work) {
    if (threads < 1) {
        throw std::invalid_argument(fmt::format("{} threads, expected at least 1", threads));
    }
    tbb::task_arena(threads).execute(work);
}

}  // namespace taut
