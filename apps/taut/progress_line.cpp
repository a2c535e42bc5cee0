// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "progress_line.hpp"

#include <fmt/core.h>

#include "terminal.hpp"

namespace taut::app {

ProgressLine::ProgressLine(bool quiet) : m_active(!quiet && is_watched()) {}

ProgressLine::~ProgressLine() {
    if (m_shown) {
        print_in_place("");
    }
}

Progress ProgressLine::progress() {
    return {
        .report = [this](std::string_view stage, int done, int total) { show(stage, done, total); },
        .stop_requested = Interruption::stop_request()};
}

void ProgressLine::show(std::string_view stage, int done, int total) {
    if (!m_active) {
        return;
    }
    const auto now = Clock::now();
    if (m_stage != stage) {
        m_stage = stage;
        m_first = done;
        m_start = now;
    } else if ((done < total || total == 0) && now - m_last < std::chrono::milliseconds(100)) {
        return;
    }
    m_last = now;
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    std::string line = total > 0 ? fmt::format("{}: {} of {}", stage, done, total)
                                 : fmt::format("{}: step {}", stage, done);
    if (total > 0 && done > m_first && seconds > 0.0) {
        const double rate = (done - m_first) / seconds;
        line += fmt::format(", {:.4g} a second, {:.0f} s left", rate, (total - done) / rate);
    }
    print_in_place(line);
    m_shown = true;
}

}  // namespace taut::app
