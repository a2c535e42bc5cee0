// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/abi.hpp"
#include "taut/error.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// Which processes receive what all processes of a group contribute.
enum class Receivers {
    first,  ///< process 0 alone: a gather
    all,    ///< each process: an all-gather
};

/// Processes that share one piece of work, for example over the nodes of a cluster:
/// with_process_group(). taut does not know how processes communicate: derive from this class and
/// implement it, by MPI for example.
class TAUT_CORE_EXPORT ProcessGroup {
public:
    ProcessGroup() = default;
    virtual ~ProcessGroup();
    ProcessGroup(const ProcessGroup&) = delete;
    ProcessGroup& operator=(const ProcessGroup&) = delete;
    ProcessGroup(ProcessGroup&&) = delete;
    ProcessGroup& operator=(ProcessGroup&&) = delete;

    /// Number of processes, at least 1.
    [[nodiscard]] virtual int size() const = 0;
    /// Number of this process, from 0.
    [[nodiscard]] virtual int rank() const = 0;
    /// Collects one part from each process. All processes call it equally often and in the same
    /// order. It waits for all of them. It is called from one thread at a time.
    /// @param part bytes that this process contributes
    /// @return all parts, in the order of the ranks; empty on processes that do not receive
    /// @throws PeerFailed if another process failed and takes no further part; Interrupted if a
    ///   stop was requested on any process
    [[nodiscard]] virtual std::vector<std::string> gather(std::string part,
                                                          Receivers receivers) = 0;

    /// Whether this process reports progress and writes files.
    [[nodiscard]] bool is_first() const { return rank() == 0; }
};

/// Another process of the group failed. what() is the message of that process.
class TAUT_CORE_EXPORT PeerFailed : public std::runtime_error, public Error {
public:
    using std::runtime_error::runtime_error;
    [[nodiscard]] ErrorCode code() const noexcept override { return ErrorCode::peer; }  ///< Error
};

/// Does the work as one process of a group. Each process makes the same calls with the same
/// arguments. These calls share their work:
///
///     Sampler::extend_to() each process draws a part of each block; the first process's data set
///                          receives the samples, those of the others stay unchanged
///     draw_samples()       likewise, but each process receives the samples
///     gp::fit()            two processes decompose for alternate values of lambda, as long as
///     train_model()        there are two; low-rank work is done by each process
///     compare_methods(), simulate_control()
///                          each process does every size()th trial
///
/// So does everything that uses them, as identify() by processes without a model, which receives
/// the results of the others. Calls that share other work out must not be made inside it. The
/// results are those of one process, bit for bit except for times, on machines of one kind.
/// @param group for all threads of this process while the work is done; no other group may be set
///   meanwhile
/// @param work called once, in the calling thread; may not be empty
/// @throws std::bad_function_call for empty work; what the work throws; and as
///   ProcessGroup::gather()
TAUT_CORE_EXPORT void with_process_group(ProcessGroup& group, const std::function<void()>& work);

/// The group of with_process_group(); outside it a group of this process alone.
[[nodiscard]] TAUT_CORE_EXPORT ProcessGroup& process_group();

}  // namespace taut
