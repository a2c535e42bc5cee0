// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/process_group.hpp"

namespace taut::app {

/// The processes that mpirun started, as a process group. Before each exchange each of them sends
/// whether it goes on, so that one that failed or has ended leaves no other waiting.
class MpiProcessGroup final : public ProcessGroup {
public:
    /// How all processes together ended.
    struct Ending {
        int code = 0;         ///< 0, or that of the failure
        std::string message;  ///< of the failure
    };

    /// Begins the use of MPI. One object a program.
    MpiProcessGroup();
    /// Does nothing, since MPI cannot be ended in order where processes are lost: see finish().
    ~MpiProcessGroup() override = default;
    MpiProcessGroup(const MpiProcessGroup&) = delete;
    MpiProcessGroup& operator=(const MpiProcessGroup&) = delete;
    MpiProcessGroup(MpiProcessGroup&&) = delete;
    MpiProcessGroup& operator=(MpiProcessGroup&&) = delete;

    [[nodiscard]] int size() const override { return m_size; }
    [[nodiscard]] int rank() const override { return m_rank; }
    [[nodiscard]] std::vector<std::string> gather(std::string part, Receivers receivers) override;

    /// Threads that this process may use without taking those of another: the sum over its
    /// processors of 1 / (processes of this machine that may use that processor).
    [[nodiscard]] int fair_threads() const;

    /// Sends to the others how this process ended, and waits for them. Where several failed, all
    /// are given the failure of the first of them. No exchange is possible afterwards.
    [[nodiscard]] Ending agree_on_ending(const Ending& own);

    /// Ends the use of MPI. Print everything before: where mpirun is ending the processes, it no
    /// longer answers, and this does not return.
    void finish() const;

private:
    /// The state of a process, sent before each exchange.
    struct Notice {
        enum State { going_on, finished, failed };
        int state = going_on;
        int code = 0;
        /// Size of what is exchanged, or of the message of a failure [bytes].
        std::ptrdiff_t length = 0;
    };

    [[nodiscard]] std::vector<Notice> meet(const Notice& own);
    [[nodiscard]] std::optional<Ending> failure_among(const std::vector<Notice>& notices,
                                                      std::string message);

    int m_size = 1;
    int m_rank = 0;
    bool m_is_lost = false;          ///< the first gave up on the others: no exchange is possible
    std::optional<Ending> m_ending;  ///< agreed on by all
};

}  // namespace taut::app
