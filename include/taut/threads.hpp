// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "taut/abi.hpp"

namespace taut {

/// While it lives, taut uses at most so many threads: of oneTBB and of the BLAS.
class ThreadLimit {
public:
    /// @param threads at least 1
    /// @throws std::invalid_argument
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;
    ThreadLimit(ThreadLimit&&) = delete;
    ThreadLimit& operator=(ThreadLimit&&) = delete;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace taut
