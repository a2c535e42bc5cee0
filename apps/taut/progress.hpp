// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace taut::app {

/// A line on a terminal's standard error that tells how far a stage of the work is, how fast it
/// goes and how long it still takes. Silent where standard error is no terminal.
class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    void show(std::string_view stage, int done, int total);

private:
    using Clock = std::chrono::steady_clock;

    bool m_active;
    bool m_shown = false;
    std::string m_stage;
    int m_first = 0;  ///< done when the stage began: nothing of it counts for the rate
    Clock::time_point m_start;
    Clock::time_point m_last;
};

}  // namespace taut::app
