// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

namespace taut {

/// Keeps BLAS to the calling thread while it lives: taut's parallel work is that of oneTBB, whose
/// threads a caller can limit, and its results are the same for any number of them. OpenBLAS knows
/// one number of threads for the whole process: the first of all objects that live sets it, the
/// last puts back what was there. MKL has one for each thread; other libraries have none that is
/// known here.
class SerialBlas {
public:
    /// @throws std::bad_alloc where a limit of the address space leaves OpenBLAS no room
    SerialBlas();
    ~SerialBlas();
    SerialBlas(const SerialBlas&) = delete;
    SerialBlas& operator=(const SerialBlas&) = delete;

private:
    [[maybe_unused]] int m_threads_before = 0;  ///< of this thread, for MKL
};

}  // namespace taut
