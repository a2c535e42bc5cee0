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
    constexpr double gibibyte = 1024.0 * mebibyte;
    const bool is_large = limit >= gibibyte;
    const double unit = is_large ? gibibyte : mebibyte;
    const auto end = fmt::format_to_n(
        m_text.data(), m_text.size() - 1,
        "not enough memory: the call needs {1:.5g} {0} or more, and may take {2:.5g} {0}",
        is_large ? "GiB" : "MiB", needed / unit, limit / unit);
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
