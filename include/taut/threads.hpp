// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <type_traits>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Does the work while taut uses at most so many threads, the calling one among them, and comes
/// back when it is done. Nothing of it stays: other threads of the process, and later calls, are
/// not limited. Within a oneTBB task arena of one's own taut keeps to that, without this function.
/// @param threads at least 1; more than the machine has are as good as all of them
/// @param work called once, in the calling thread; may not be empty
/// @throws std::invalid_argument for fewer than 1; std::bad_function_call for empty work; and what
///   the work throws
TAUT_CORE_EXPORT void with_threads(int threads, const std::function<void()>& work);

/// The same, and gives what the work gives, which must be a value that can be moved:
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

}  // namespace taut
