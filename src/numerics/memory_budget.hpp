// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "taut/export/core.hpp"

namespace taut {

/// The memory that a call may take for its large arrays (with_memory()), shared by its threads.
class TAUT_CORE_EXPORT MemoryBudget {
public:
    /// @param bytes of this budget; the outer one, if there is one, pays as well
    MemoryBudget(double bytes, std::shared_ptr<MemoryBudget> outer);

    /// @throws MemoryLimitExceeded where less is left; then nothing is taken
    void take(double bytes);
    void give_back(double bytes) noexcept;

private:
    double m_limit;
    std::atomic<double> m_taken = 0.0;
    std::shared_ptr<MemoryBudget> m_outer;
};

/// The budget of what this thread does; null where there is none.
[[nodiscard]] TAUT_CORE_EXPORT std::shared_ptr<MemoryBudget> memory_budget();

/// Sets the budget of what this thread does, as long as it lives.
class TAUT_CORE_EXPORT BudgetScope {
public:
    explicit BudgetScope(const std::shared_ptr<MemoryBudget>& budget);
    ~BudgetScope();
    BudgetScope(const BudgetScope&) = delete;
    BudgetScope& operator=(const BudgetScope&) = delete;
    BudgetScope(BudgetScope&&) = delete;
    BudgetScope& operator=(BudgetScope&&) = delete;

private:
    const std::shared_ptr<MemoryBudget>* m_before;
};

/// What an array takes of the budget of the thread that makes it, as long as this lives.
class MemoryCharge {
public:
    MemoryCharge() = default;
    /// @throws MemoryLimitExceeded
    explicit MemoryCharge(double bytes) : m_budget(memory_budget()), m_bytes(bytes) {
        if (m_budget) {
            m_budget->take(bytes);
        }
    }
    ~MemoryCharge() { release(); }
    MemoryCharge(MemoryCharge&& other) noexcept
        : m_budget(std::move(other.m_budget)), m_bytes(other.m_bytes) {}
    MemoryCharge& operator=(MemoryCharge&& other) noexcept {
        release();
        m_budget = std::move(other.m_budget);
        m_bytes = other.m_bytes;
        return *this;
    }
    MemoryCharge(const MemoryCharge&) = delete;
    MemoryCharge& operator=(const MemoryCharge&) = delete;

private:
    void release() noexcept {
        if (m_budget) {
            m_budget->give_back(m_bytes);
            m_budget.reset();
        }
    }

    std::shared_ptr<MemoryBudget> m_budget;
    double m_bytes = 0.0;
};

/// Of arrays of so many numbers.
[[nodiscard]] inline MemoryCharge charge_numbers(double count) {
    return MemoryCharge(count * sizeof(double));
}

}  // namespace taut
