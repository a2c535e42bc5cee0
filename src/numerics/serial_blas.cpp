// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/serial_blas.hpp"

#include <mutex>

// The one that CMake found: cmake/dependencies.cmake.
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

std::mutex mutex;
int living = 0;
int threads_before = 1;

}  // namespace

SerialBlas::SerialBlas() {
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
