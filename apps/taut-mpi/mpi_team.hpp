// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/team.hpp"

namespace taut::app {

/// The processes that mpirun started, as a team. Before each exchange they tell each other whether
/// they go on, so that one that failed or came to its end leaves no other waiting.
class MpiTeam final : public Team {
public:
    /// How all processes together ended.
    struct Ending {
        int code = 0;         ///< 0, or that of the failure
        std::string message;  ///< of the failure
    };

    /// Begins the use of MPI. One object a program.
    MpiTeam();
    /// Nothing: where processes are lost MPI cannot be ended in order. finish() does.
    ~MpiTeam() override = default;
    MpiTeam(const MpiTeam&) = delete;
    MpiTeam& operator=(const MpiTeam&) = delete;
    MpiTeam(MpiTeam&&) = delete;
    MpiTeam& operator=(MpiTeam&&) = delete;

    [[nodiscard]] int size() const override { return m_size; }
    [[nodiscard]] int rank() const override { return m_rank; }
    [[nodiscard]] std::vector<std::string> gather(std::string part, Receivers receivers) override;

    /// The threads that this process may use without taking another one's: of each processor that
    /// the system lets it use, its share among the processes that may use it, too.
    [[nodiscard]] int fair_threads() const;

    /// Tells the others how this process ended, and waits for them. Where several failed, the first
    /// of them tells for all. No exchange is possible afterwards.
    [[nodiscard]] Ending agree_on_ending(const Ending& own);

    /// Ends the use of MPI. Whatever is to be told is told before: where mpirun ends processes it
    /// no longer answers, and they do not come back from this.
    void finish() const;

private:
    /// What processes tell of themselves before an exchange.
    struct Notice {
        enum State { going_on, finished, failed };
        int state = going_on;
        int code = 0;
        /// Of what is exchanged, or of the message of a failure [bytes].
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
