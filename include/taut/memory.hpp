// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <new>
#include <optional>
#include <type_traits>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// A call needs more memory than with_memory() grants.
class TAUT_CORE_EXPORT MemoryLimitExceeded : public std::bad_alloc, public Error {
public:
    /// @param needed by the call so far and for what it asks [bytes]
    /// @param limit of the call [bytes]
    MemoryLimitExceeded(double needed, double limit) noexcept;
    [[nodiscard]] const char* what() const noexcept override {
        return m_text.data();
    }  ///< one line
    [[nodiscard]] ErrorCode code() const noexcept override {
        return ErrorCode::out_of_memory;
    }  ///< Error

private:
    std::array<char, 128> m_text{};
};

/// Does the work with at most so much memory in taut, and returns when it is done. What counts are
/// the large arrays: factors and inverses of matrices, spectra of kernels, data sets, covariances
/// and posterior samples, before they are made. They are most of what taut takes for large nets
/// and many samples; vectors of one number for each node or edge are not counted. What a call
/// has returned is no longer counted, but for factors that it holds. Calls in other threads of the
/// program have limits of their own; inside another such limit both hold.
/// @param bytes more than 0
/// @param work called once, in the calling thread; may not be empty
/// @throws std::invalid_argument for other bytes; MemoryLimitExceeded, and what the work throws
TAUT_CORE_EXPORT void with_memory(double bytes, const std::function<void()>& work);

/// The same, returning the result of the work, which must be movable:
///
///     const auto found = with_memory(2e9, [&] { return identify(net, survey); });
///
/// @throws as above
template <class Work>
    requires(!std::is_void_v<std::invoke_result_t<Work>>)
[[nodiscard]] auto with_memory(double bytes, Work&& work) -> std::invoke_result_t<Work> {
    std::optional<std::invoke_result_t<Work>> result;
    with_memory(bytes, std::function<void()>([&] { result.emplace(work()); }));
    return *std::move(result);
}

}  // namespace taut
