// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>
#include <version>

#include "taut/export/core.hpp"

// taut's interface passes Eigen matrices and containers of the standard library. Both sides must
// lay out, align and free them alike, but compiler flags change this: -mavx and -march=native how
// Eigen aligns, -fsanitize=address how it allocates, -D_GLIBCXX_DEBUG what a std::vector is. Other
// storage orders and indices of Eigen, and packed structs, do not compile below. Linking
// taut::taut, or `pkg-config --cflags taut`, adds the definitions that fix what Eigen does,
// whatever the flags. Remaining differences do not link: the name of the symbol below encodes what
// a source was compiled for, and the library has only its own. docs/linking.md.
#if defined(_LIBCPP_VERSION)
#define TAUT_ABI_STANDARD_LIBRARY libcxx
#elif defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define TAUT_ABI_STANDARD_LIBRARY libstdcxx_old_strings
#elif defined(_GLIBCXX_DEBUG)
#define TAUT_ABI_STANDARD_LIBRARY libstdcxx_debug
#elif defined(_MSC_VER)
#define TAUT_ABI_STANDARD_LIBRARY msvc
#else
#define TAUT_ABI_STANDARD_LIBRARY libstdcxx
#endif

// Eigen is 3.4 or 5.x: EIGEN_MAJOR_VERSION differs between them.
#define TAUT_ABI_PASTE(library, major, heap, stack, by_malloc) \
    compiled_for_##library##_eigen_##major##_aligned_to_##heap##_and_##stack##_by_malloc_##by_malloc
#define TAUT_ABI_NAME(library, major, heap, stack, by_malloc) \
    TAUT_ABI_PASTE(library, major, heap, stack, by_malloc)
#define TAUT_ABI                                                                         \
    TAUT_ABI_NAME(TAUT_ABI_STANDARD_LIBRARY, EIGEN_MAJOR_VERSION, EIGEN_MAX_ALIGN_BYTES, \
                  EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED)

namespace taut::border {

static_assert(!Eigen::MatrixXd::IsRowMajor,
              "taut passes matrices by columns: undefine EIGEN_DEFAULT_TO_ROW_MAJOR");
static_assert(std::is_same_v<Eigen::Index, std::ptrdiff_t>,
              "taut is compiled with Eigen's own index: undefine EIGEN_DEFAULT_DENSE_INDEX_TYPE");
struct Padded {
    char first;
    double second;
};
// max_align_t is 16 bytes on WebAssembly, too, and 8 on 64-bit systems whose malloc() does more.
static_assert(sizeof(void*) >= 8 || alignof(std::max_align_t) >= 16,
              "taut needs a system whose malloc() aligns to 16 bytes");
static_assert(sizeof(Padded) > sizeof(char) + sizeof(double),
              "taut passes structs as the ABI packs them: leave out -fpack-struct");

extern TAUT_CORE_EXPORT const char TAUT_ABI;

namespace {
[[maybe_unused, gnu::used]] const char* const is_as_the_library = &TAUT_ABI;
}  // namespace

}  // namespace taut::border
