// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/memory.hpp"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "numerics/memory_budget.hpp"

namespace taut {

MemoryLimitExceeded::MemoryLimitExceeded(double needed, double limit) noexcept {
    constexpr double mebibyte = 1024.0 * 1024.0;
    const auto end = fmt::format_to_n(
        m_text.data(), m_text.size() - 1,
        "not enough memory: the call needs {:.5g} MiB or more, and may take {:.5g} MiB",
        needed / mebibyte, limit / mebibyte);
    *end.out = '\0';
}

void with_memory(double bytes, const std::function<void()>& work) {
    if (!(bytes > 0.0)) {
        throw std::invalid_argument(fmt::format("{} bytes of memory, expected more than 0", bytes));
    }
    const auto budget = std::make_shared<MemoryBudget>(bytes, memory_budget());
    const BudgetScope scope(budget);
    work();
}

}  // namespace taut
