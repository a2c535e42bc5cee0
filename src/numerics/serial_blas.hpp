// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

namespace taut {

/// Restricts BLAS to the calling thread during its lifetime. taut parallelises by oneTBB, whose
/// threads a caller can limit, and its results are the same for any number of them. OpenBLAS has
/// one number of threads for the whole process: the first living object sets it to 1, the last one
/// restores it. MKL has one for each thread. For other libraries none is known here.
class SerialBlas {
public:
    /// @throws std::bad_alloc if a limit of the address space leaves no room for OpenBLAS's buffers
    SerialBlas();
    ~SerialBlas();
    SerialBlas(const SerialBlas&) = delete;
    SerialBlas& operator=(const SerialBlas&) = delete;

private:
    [[maybe_unused]] int m_threads_before = 0;  ///< of this thread, for MKL
};

}  // namespace taut
