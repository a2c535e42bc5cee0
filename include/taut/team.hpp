// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Who is given what the processes of a team made.
enum class Receivers {
    first,  ///< the first process alone
    all,    ///< each process
};

/// Processes that do one piece of work together, over the nodes of a cluster, say: with_team().
/// taut does not know how processes reach each other; whoever does derives from this.
class TAUT_CORE_EXPORT Team {
public:
    Team() = default;
    virtual ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    Team(Team&&) = delete;
    Team& operator=(Team&&) = delete;

    /// How many processes there are, at least one.
    [[nodiscard]] virtual int size() const = 0;
    /// Which of them this is, from 0.
    [[nodiscard]] virtual int rank() const = 0;
    /// Gives what each process made, in the order of their ranks, to the receivers, and nothing to
    /// others. All processes call it as often and in the same order; it waits for them, and is
    /// called from one thread at a time.
    /// @param part bytes that this process made
    /// @throws TeammateFailed where another process failed and takes no more part; Interrupted
    ///   where a stop was requested of one
    [[nodiscard]] virtual std::vector<std::string> gather(std::string part,
                                                          Receivers receivers) = 0;

    /// Whether this is the one that tells and writes.
    [[nodiscard]] bool is_first() const { return rank() == 0; }
};

/// Another process of the team failed, in its words.
class TAUT_CORE_EXPORT TeammateFailed : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Does the work as one of a team. Each process makes the same calls with the same arguments; of
/// these
///
///     Sampler::extend()    draws a part of each block; the samples go to the first process's data
///                          set, and those of the others stay as they are
///     draw_samples()       likewise, but each process is given the samples
///     gp::fit(), train()   decomposes for every second lambda, as long as there are two; what is
///                          done by low rank, each does by itself
///     compare_methods(), simulate_control()
///                          does every size()th trial
///
/// and all that uses these, as identify() by processes without a model does, and is given what the
/// others made. Who shares other work out must not call these in it. What comes out is the same,
/// bit for bit, as of one process, but for times; on machines of one kind.
/// @param team for all threads of this process while the work is done; meanwhile none may be set
/// @param work called once, in the calling thread; may not be empty
/// @throws std::bad_function_call for empty work; what the work throws; and as Team::gather()
TAUT_CORE_EXPORT void with_team(Team& team, const std::function<void()>& work);

/// That of with_team(), or this process by itself.
[[nodiscard]] TAUT_CORE_EXPORT Team& team();

}  // namespace taut
