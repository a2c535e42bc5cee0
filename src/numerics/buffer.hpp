// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <new>

#include "numerics/memory_budget.hpp"
#include "platform/platform.hpp"

namespace taut {

/// Uninitialised memory for `count` numbers. Large buffers use large pages if the machine has them:
/// the first touch of each page costs as much as thousands of additions.
class Buffer {
public:
    Buffer() = default;
    explicit Buffer(std::size_t count)
        : m_charge(charge_numbers(static_cast<double>(count))),
          m_memory(static_cast<double*>(::operator new(count * sizeof(double), alignment(count))),
                   Free(alignment(count))),
          m_count(count) {
        if (count * sizeof(double) >= large_page) {
            platform::prefer_large_pages(m_memory.get(), count * sizeof(double));
        }
    }

    [[nodiscard]] double* data() const { return m_memory.get(); }
    [[nodiscard]] std::size_t size() const { return m_count; }
    [[nodiscard]] bool empty() const { return m_count == 0; }

private:
    static constexpr std::size_t large_page = std::size_t{1} << 21U;
    static std::align_val_t alignment(std::size_t count) {
        return std::align_val_t{count * sizeof(double) >= large_page ? large_page : 64};
    }
    struct Free {
        Free() : Free(std::align_val_t{64}) {}
        explicit Free(std::align_val_t with) : alignment(with) {}
        std::align_val_t alignment;
        void operator()(double* memory) const { ::operator delete(memory, alignment); }
    };

    MemoryCharge m_charge;
    std::unique_ptr<double, Free> m_memory;
    std::size_t m_count = 0;
};

}  // namespace taut
