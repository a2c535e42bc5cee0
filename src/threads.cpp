// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/threads.hpp"

#include <cblas.h>
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <stdexcept>

namespace taut {

struct ThreadLimit::State {
    explicit State(int threads)
        : tbb_limit(tbb::global_control::max_allowed_parallelism, threads) {}

    tbb::global_control tbb_limit;
    int blas_threads_before = openblas_get_num_threads();
};

ThreadLimit::ThreadLimit(int threads) {
    if (threads < 1) {
        throw std::invalid_argument(fmt::format("{} threads, expected at least 1", threads));
    }
    m_state = std::make_unique<State>(threads);
    openblas_set_num_threads(threads);
}

ThreadLimit::~ThreadLimit() {
    openblas_set_num_threads(m_state->blas_threads_before);
}

}  // namespace taut
