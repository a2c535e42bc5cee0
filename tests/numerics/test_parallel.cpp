// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards loops inside loops: one that returns has done all of its work, whatever happens around it.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "numerics/parallel.hpp"

namespace taut {
namespace {

using namespace std::chrono_literals;

void wait_for(const std::atomic<bool>& flag) {
    for (int k = 0; k < 2000 && !flag; ++k) {
        std::this_thread::sleep_for(1ms);
    }
}

TEST(Parallel, InnerLoopsAreCompleteThoughTheOuterOneFails) {
    if (arena_size() < 2) {
        GTEST_SKIP() << "one thread alone";
    }
    constexpr int count = 100;
    std::atomic<bool> has_begun = false;
    std::atomic<int> done = 0;
    std::atomic<int> done_at_return = -1;
    const auto fails = [&] {
        wait_for(has_begun);
        throw std::runtime_error("no memory");
    };
    const auto works = [&] {
        isolate([&] {
            parallel_for(0, count, [&](int) {
                has_begun = true;
                std::this_thread::sleep_for(2ms);
                ++done;
            });
        });
        done_at_return = done.load();
    };
    EXPECT_THROW(parallel_for(0, 2, [&](int k) { k == 0 ? fails() : works(); }),
                 std::runtime_error);
    if (done_at_return < 0) {
        GTEST_SKIP() << "the other thread did not come";
    }
    EXPECT_EQ(done_at_return, count);
}

TEST(Parallel, InnerLoopsThrowWhatIsThrownInThem) {
    EXPECT_THROW(parallel_for(0, 4,
                              [](int) {
                                  parallel_for(0, 4, [](int k) {
                                      if (k == 2) {
                                          throw std::runtime_error("within");
                                      }
                                  });
                              }),
                 std::runtime_error);
}

}  // namespace
}  // namespace taut
