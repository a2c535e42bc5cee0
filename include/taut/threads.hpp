// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <type_traits>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Does the work with at most this number of threads in taut, the calling one included, and returns
/// when it is done. Other threads of the process and later calls are not limited. Inside a oneTBB
/// task arena of the caller, taut uses the threads of that arena, without this function. A taut
/// that was built without oneTBB takes the calling thread alone.
/// @param threads at least 1; more than the machine has mean all of them
/// @param work called once, in the calling thread; may not be empty
/// @throws std::invalid_argument for fewer than 1; std::bad_function_call for empty work; and what
///   the work throws
TAUT_CORE_EXPORT void with_threads(int threads, const std::function<void()>& work);

/// The same, returning the result of the work, which must be movable:
///
///     const auto found = with_threads(1, [&] { return identify(net, survey); });
///
/// @throws std::invalid_argument for fewer than 1 thread; and what the work throws
template <class Work>
    requires(!std::is_void_v<std::invoke_result_t<Work>>)
[[nodiscard]] auto with_threads(int threads, Work&& work) -> std::invoke_result_t<Work> {
    std::optional<std::invoke_result_t<Work>> result;
    with_threads(threads, std::function<void()>([&] { result.emplace(work()); }));
    return *std::move(result);
}

/// Threads that taut takes at most where this is called: 1 where it was built without oneTBB.
[[nodiscard]] TAUT_CORE_EXPORT int max_threads();

}  // namespace taut
