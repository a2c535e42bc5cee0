// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "taut/progress.hpp"

namespace taut::app {

/// A line on a terminal that shows how far a stage of the work is, its rate and the time left.
/// Silent where standard error is not a terminal.
class ProgressLine {
public:
    explicit ProgressLine(bool quiet);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ProgressLine(ProgressLine&&) = delete;
    ProgressLine& operator=(ProgressLine&&) = delete;

    /// Shows progress on this line, and requests a stop after a signal. It must not outlive the
    /// line.
    [[nodiscard]] Progress progress();

private:
    void show(std::string_view stage, int done, int total);

    using Clock = std::chrono::steady_clock;

    bool m_active;
    bool m_shown = false;
    std::string m_stage;
    int m_first = 0;  ///< steps done when the stage began; they do not count for the rate
    Clock::time_point m_start;
    Clock::time_point m_last;
};

}  // namespace taut::app
