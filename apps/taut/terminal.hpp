// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>

namespace taut::app {

/// The exit code after SIGINT, as shells have it.
inline constexpr int interrupted = 130;

/// Whether standard error is shown to somebody.
[[nodiscard]] bool is_watched();

/// What SIGINT, SIGTERM and SIGHUP do. A command that says nothing is ended at once with exit code
/// 130; its outputs appear in one piece or not at all, so nothing is left half done. A command that
/// asks for stop_request() is told by it, and ended at once by a second signal.
class Interruption {
public:
    /// Call once. Signals that are ignored stay so.
    static void watch();

    /// From now on the first signal does no more than to request a stop: whether it came.
    [[nodiscard]] static std::function<bool()> stop_request();
};

/// Sampling was interrupted and what is done was kept: the message tells where.
class SampleInterrupted : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace taut::app
