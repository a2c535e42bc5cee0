// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <metis.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <new>

#include "numerics/nested_dissection.hpp"

namespace taut {
namespace {

/// METIS calls rand(). A state of its own leaves the program's sequence undisturbed, and makes the
/// order always the same. rand() has one state a process, hence the lock.
class OwnRandomState {
public:
    OwnRandomState() : m_before(initstate(1, m_state.data(), m_state.size())) {}
    ~OwnRandomState() { setstate(m_before); }
    OwnRandomState(const OwnRandomState&) = delete;
    OwnRandomState& operator=(const OwnRandomState&) = delete;

private:
    std::array<char, 128> m_state{};
    char* m_before;
};

std::mutex one_at_a_time;

}  // namespace

std::vector<int> nested_dissection(const MatrixGraph& graph) {
    const std::scoped_lock lock(one_at_a_time);
    const OwnRandomState random;
    std::vector<idx_t> starts(graph.starts.begin(), graph.starts.end());
    std::vector<idx_t> neighbours(graph.neighbours.begin(), graph.neighbours.end());
    idx_t count = graph.row_count();
    std::vector<idx_t> order(graph.row_count());
    std::vector<idx_t> place(graph.row_count());
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = 1;
    options[METIS_OPTION_COMPRESS] = 0;  // no two nodes of a net have the same neighbours
    switch (METIS_NodeND(&count, starts.data(), neighbours.data(), nullptr, options.data(),
                         order.data(), place.data())) {
        case METIS_OK:
            return {order.begin(), order.end()};
        case METIS_ERROR_MEMORY:
            throw std::bad_alloc();
        default:
            // METIS catches SIGTERM, which asks the process to end, and returns: raise it again.
            std::raise(SIGTERM);
            return {};
    }
}

}  // namespace taut
