// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "mpi_process_group.hpp"

#include <fmt/core.h>
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

#include "taut/progress.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;
using std::chrono::milliseconds;

/// How long the first process waits for the others after a stop was requested: they may be lost or
/// busy, and it has samples to keep. mpirun leaves a second between its request and the end.
constexpr milliseconds patience{300};

/// MPI counts with int, so more is exchanged in rounds [bytes].
constexpr std::ptrdiff_t most_at_once = std::ptrdiff_t{1} << 30;

/// Waits without taking a processor from those that still work: MPI's own waiting takes a whole
/// one.
/// @return false where nothing came within `patience` of a requested stop
bool wait_idly(MPI_Request& request, bool may_give_up) {
    std::optional<Clock::time_point> last;
    for (microseconds pause{10};; pause = std::min(2 * pause, microseconds{2000})) {
        int is_done = 0;
        MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
        if (is_done != 0) {
            return true;
        }
        if (may_give_up && Interruption::is_requested()) {
            last = last.value_or(Clock::now() + patience);
            if (Clock::now() > *last) {
                return false;
            }
        }
        std::this_thread::sleep_for(pause);
    }
}

/// Slices of what each process has, one behind the other.
struct Slices {
    std::vector<int> lengths;
    std::vector<int> places;
    std::vector<char> bytes;

    Slices(const std::vector<std::ptrdiff_t>& whole, std::ptrdiff_t from, std::ptrdiff_t most,
           bool receives)
        : lengths(whole.size()), places(whole.size()) {
        int place = 0;
        for (size_t rank = 0; rank < whole.size(); ++rank) {
            lengths[rank] =
                static_cast<int>(std::clamp(whole[rank] - from, std::ptrdiff_t{0}, most));
            places[rank] = place;
            place += lengths[rank];
        }
        bytes.resize(receives ? static_cast<size_t>(place) : 0);
    }
};

cpu_set_t allowed_processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof(set), &set);
    return set;
}

}  // namespace

MpiProcessGroup::MpiProcessGroup() {
    int provided = 0;
    // Any thread of oneTBB may come to an exchange, one at a time.
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &m_size);
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    if (provided < MPI_THREAD_SERIALIZED) {
        throw std::runtime_error("this MPI does not let threads call it one after the other");
    }
}

std::vector<MpiProcessGroup::Notice> MpiProcessGroup::meet(const Notice& own) {
    struct Exchange {
        Notice own;
        std::vector<Notice> all;
    };
    auto exchange =
        std::make_unique<Exchange>(own, std::vector<Notice>(static_cast<size_t>(m_size)));
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgather(&exchange->own, sizeof(Notice), MPI_BYTE, exchange->all.data(), sizeof(Notice),
                   MPI_BYTE, MPI_COMM_WORLD, &request);
    if (!wait_idly(request, is_first())) {
        m_is_lost = true;
        static_cast<void>(exchange.release());  // MPI may still read and write there
        throw Interrupted();
    }
    return std::move(exchange->all);
}

std::optional<MpiProcessGroup::Ending> MpiProcessGroup::failure_among(
    const std::vector<Notice>& notices, std::string message) {
    const auto first = std::ranges::find(notices, int{Notice::failed}, &Notice::state);
    if (first == notices.end()) {
        return std::nullopt;
    }
    message.resize(static_cast<size_t>(first->length));
    MPI_Bcast(message.data(), static_cast<int>(message.size()), MPI_BYTE,
              static_cast<int>(first - notices.begin()), MPI_COMM_WORLD);
    m_ending = Ending{.code = first->code, .message = std::move(message)};
    return m_ending;
}

std::vector<std::string> MpiProcessGroup::gather(std::string part, Receivers receivers) {
    const std::vector<Notice> notices = meet({.length = std::ssize(part)});
    if (const auto failure = failure_among(notices, "")) {
        if (failure->code == interrupted) {
            throw Interrupted();
        }
        throw PeerFailed(failure->message);
    }
    if (std::ranges::find(notices, int{Notice::finished}, &Notice::state) != notices.end()) {
        std::fputs("taut: error: internal error: processes came to different ends\n", stderr);
        MPI_Abort(MPI_COMM_WORLD, numerical_failure);
    }
    std::vector<std::ptrdiff_t> lengths(notices.size());
    std::ranges::transform(notices, lengths.begin(), &Notice::length);
    const bool receives = m_rank == 0 || receivers == Receivers::all;
    std::vector<std::string> parts(receives ? lengths.size() : 0);
    const std::ptrdiff_t most = std::max<std::ptrdiff_t>(1, most_at_once / m_size);
    for (std::ptrdiff_t from = 0; from < std::ranges::max(lengths); from += most) {
        Slices slices(lengths, from, most, receives);
        const std::ptrdiff_t begin = std::min(from, std::ssize(part));
        if (receivers == Receivers::all) {
            MPI_Allgatherv(part.data() + begin, slices.lengths[m_rank], MPI_BYTE,
                           slices.bytes.data(), slices.lengths.data(), slices.places.data(),
                           MPI_BYTE, MPI_COMM_WORLD);
        } else {
            MPI_Gatherv(part.data() + begin, slices.lengths[m_rank], MPI_BYTE, slices.bytes.data(),
                        slices.lengths.data(), slices.places.data(), MPI_BYTE, 0, MPI_COMM_WORLD);
        }
        for (size_t rank = 0; rank < parts.size(); ++rank) {
            parts[rank].append(slices.bytes.data() + slices.places[rank],
                               static_cast<size_t>(slices.lengths[rank]));
        }
    }
    return parts;
}

int MpiProcessGroup::fair_threads() const {
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, m_rank, MPI_INFO_NULL, &machine);
    int processes = 1;
    MPI_Comm_size(machine, &processes);
    const cpu_set_t own = allowed_processors();
    std::vector<cpu_set_t> sets(static_cast<size_t>(processes));
    MPI_Allgather(&own, sizeof(own), MPI_BYTE, sets.data(), sizeof(own), MPI_BYTE, machine);
    MPI_Comm_free(&machine);
    double share = 0.0;
    for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
        if (CPU_ISSET(processor, &own)) {
            share +=
                1.0 / static_cast<double>(std::ranges::count_if(
                          sets, [&](const cpu_set_t& set) { return CPU_ISSET(processor, &set); }));
        }
    }
    constexpr double rounding = 1e-6;
    return std::max(1, static_cast<int>(share + rounding));
}

MpiProcessGroup::Ending MpiProcessGroup::agree_on_ending(const Ending& own) {
    if (!m_is_lost && !m_ending) {
        try {
            const auto notices = meet({.state = own.code == 0 ? Notice::finished : Notice::failed,
                                       .code = own.code,
                                       .length = std::ssize(own.message)});
            if (failure_among(notices, own.message)) {
                return *m_ending;
            }
            m_ending = Ending{};
            if (std::ranges::find(notices, int{Notice::going_on}, &Notice::state) !=
                notices.end()) {
                m_ending = Ending{.code = numerical_failure,
                                  .message = "internal error: processes came to different ends"};
            }
        } catch (const Interrupted&) {
            m_is_lost = true;  // the first gave up on the others, as meet() has noted
        }
    }
    return m_is_lost ? own : *m_ending;
}

void MpiProcessGroup::finish() const {
    if (!m_is_lost) {
        MPI_Finalize();
    }  // else the others wait for the first, and mpirun ends them when it is gone
}

}  // namespace taut::app
