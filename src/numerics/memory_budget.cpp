// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/memory_budget.hpp"

#include <utility>

#include "taut/memory.hpp"

namespace taut {
namespace {

/// Held by the scope that set it. None: null.
thread_local const std::shared_ptr<MemoryBudget>* current = nullptr;

}  // namespace

MemoryBudget::MemoryBudget(double bytes, std::shared_ptr<MemoryBudget> outer)
    : m_limit(bytes), m_outer(std::move(outer)) {}

void MemoryBudget::take(double bytes) {
    if (m_outer) {
        m_outer->take(bytes);
    }
    double taken = m_taken;
    do {
        if (taken + bytes > m_limit) {
            if (m_outer) {
                m_outer->give_back(bytes);
            }
            throw MemoryLimitExceeded(taken + bytes, m_limit);
        }
    } while (!m_taken.compare_exchange_weak(taken, taken + bytes));
}

void MemoryBudget::give_back(double bytes) noexcept {
    double taken = m_taken;
    while (!m_taken.compare_exchange_weak(taken, taken - bytes)) {
    }
    if (m_outer) {
        m_outer->give_back(bytes);
    }
}

std::shared_ptr<MemoryBudget> memory_budget() {
    return current != nullptr ? *current : nullptr;
}

BudgetScope::BudgetScope(const std::shared_ptr<MemoryBudget>& budget)
    : m_before(std::exchange(current, &budget)) {}

BudgetScope::~BudgetScope() {
    current = m_before;
}

}  // namespace taut
