// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/serial_blas.hpp"

#include <mutex>
#include <new>

#include "numerics/parallel.hpp"
#include "platform/platform.hpp"

// The BLAS that CMake found: cmake/dependencies.cmake.
#if defined(TAUT_BLAS_IS_OPENBLAS)
extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int threads);
}
#elif defined(TAUT_BLAS_IS_MKL)
extern "C" int MKL_Set_Num_Threads_Local(int threads);  // gives the number before
#endif

namespace taut {

#if defined(TAUT_BLAS_IS_OPENBLAS)
namespace {

/// OpenBLAS allocates a buffer for each thread that calls it, and retries for ever if it gets none.
bool has_room_for_buffers() {
    constexpr double buffer = 128.0 * 1024.0 * 1024.0;  // bytes, of builds for x86-64
    return platform::can_map(buffer * arena_size());
}

std::mutex mutex;
int living = 0;
int threads_before = 1;

}  // namespace

SerialBlas::SerialBlas() {
    static const bool has_room = has_room_for_buffers();
    if (!has_room) {
        throw std::bad_alloc();
    }
    const std::scoped_lock lock(mutex);
    if (living++ == 0) {
        threads_before = openblas_get_num_threads();
        if (threads_before != 1) {
            openblas_set_num_threads(1);
        }
    }
}

SerialBlas::~SerialBlas() {
    const std::scoped_lock lock(mutex);
    if (--living == 0 && threads_before != 1) {
        openblas_set_num_threads(threads_before);
    }
}
#elif defined(TAUT_BLAS_IS_MKL)
SerialBlas::SerialBlas() : m_threads_before(MKL_Set_Num_Threads_Local(1)) {}

SerialBlas::~SerialBlas() {
    MKL_Set_Num_Threads_Local(m_threads_before);
}
#else
SerialBlas::SerialBlas() = default;
SerialBlas::~SerialBlas() = default;
#endif

}  // namespace taut
