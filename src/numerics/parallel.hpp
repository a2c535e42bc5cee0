// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#if !defined(TAUT_WITHOUT_TBB)
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <memory>
#else
#include <functional>
#include <optional>
#include <utility>
#endif

#ifdef _WIN32  // macros of the system's header, which oneTBB reads there
#undef far
#undef near
#endif

#include "numerics/memory_budget.hpp"

/// All that runs in parallel, on the threads of oneTBB. Where taut was built without it
/// (TAUT_WITH_TBB), the same runs on the calling thread, one after the other.
namespace taut {

#if !defined(TAUT_WITHOUT_TBB)

/// Calls body(index) for first .. last - 1, in any order: for all of them, or it throws. A loop
/// that is inside another one is not cancelled with it, as oneTBB's are: it would return with a
/// part of its work undone, and what follows it would not know.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
    const std::shared_ptr<MemoryBudget> budget = memory_budget();
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::parallel_for(
        first, last,
        [&](Index index) {
            const BudgetScope scope(budget);
            body(index);
        },
        context);
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    const std::shared_ptr<MemoryBudget> budget = memory_budget();
    const auto within = [&](const auto& work) {
        const BudgetScope scope(budget);
        work();
    };
    tbb::task_group_context context(tbb::task_group_context::isolated);
    tbb::parallel_invoke([&] { within(first); }, [&] { within(second); }, context);
}

/// Calls work, during which a thread that waits takes up nothing from outside.
template <class Work>
void isolate(const Work& work) {
    tbb::this_task_arena::isolate(work);
}

/// A value for each thread, made when that first asks for it: local().
template <class Value>
using PerThread = tbb::enumerable_thread_specific<Value>;

/// Threads that work of the caller may take.
inline int arena_size() {
    return tbb::this_task_arena::max_concurrency();
}

/// Calls work, which may take so many threads, and no more than there are.
template <class Work>
void limit_threads(int threads, const Work& work) {
    // An arena allocates memory for each thread, and oneTBB fails for very large numbers.
    const std::shared_ptr<MemoryBudget> budget = memory_budget();
    tbb::task_arena(std::min(threads, tbb::info::default_concurrency())).execute([&] {
        const BudgetScope scope(budget);  // it may be another thread
        work();
    });
}

#else

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
    for (Index index = first; index < last; ++index) {
        body(index);
    }
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    first();
    second();
}

template <class Work>
void isolate(const Work& work) {
    work();
}

template <class Value>
class PerThread {
public:
    PerThread() : m_make([] { return Value(); }) {}
    template <class Make>
    explicit PerThread(Make make) : m_make(std::move(make)) {}

    Value& local() { return m_value ? *m_value : m_value.emplace(m_make()); }

private:
    std::function<Value()> m_make;
    std::optional<Value> m_value;
};

inline int arena_size() {
    return 1;
}

template <class Work>
void limit_threads(int /*threads*/, const Work& work) {
    work();
}

#endif

}  // namespace taut
