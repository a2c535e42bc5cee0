// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <Eigen/Core>
#include <version>

#include "taut/export/core.hpp"

// taut hands over matrices of Eigen and containers of the standard library. Both sides must lay
// them out, align and free them alike, which flags of a compiler change: -mavx and -march=native
// how Eigen aligns, -fsanitize=address how it allocates, -D_GLIBCXX_DEBUG what a std::vector is.
// Linking taut::taut, or `pkg-config --cflags taut`, brings the definitions along that fix what
// Eigen does, whatever the flags. What is different all the same does not link: the symbol below
// tells in its name what a source was compiled for, and the library has only its own.
// docs/architecture.md, "The border".
#if defined(_LIBCPP_VERSION)
#define TAUT_ABI_STANDARD_LIBRARY libcxx
#elif defined(_GLIBCXX_DEBUG)
#define TAUT_ABI_STANDARD_LIBRARY libstdcxx_debug
#elif defined(_MSC_VER)
#define TAUT_ABI_STANDARD_LIBRARY msvc
#else
#define TAUT_ABI_STANDARD_LIBRARY libstdcxx
#endif

// The version of Eigen is 3.4 or 5.x: the second number of the old ones tells both apart.
#define TAUT_ABI_PASTE(library, major, heap, stack, by_malloc) \
    compiled_for_##library##_eigen_##major##_aligned_to_##heap##_and_##stack##_by_malloc_##by_malloc
#define TAUT_ABI_NAME(library, major, heap, stack, by_malloc) \
    TAUT_ABI_PASTE(library, major, heap, stack, by_malloc)
#define TAUT_ABI                                                                         \
    TAUT_ABI_NAME(TAUT_ABI_STANDARD_LIBRARY, EIGEN_MAJOR_VERSION, EIGEN_MAX_ALIGN_BYTES, \
                  EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED)

namespace taut::abi {

extern TAUT_CORE_EXPORT const char TAUT_ABI;

namespace {
[[maybe_unused, gnu::used]] const char* const is_as_the_library = &TAUT_ABI;
}  // namespace

}  // namespace taut::abi
