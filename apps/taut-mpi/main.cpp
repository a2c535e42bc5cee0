// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// taut over the processes of a cluster. All of them run the same command; the first alone tells and
// writes.

#include <exception>
#include <string>
#include <string_view>

#include "command.hpp"
#include "mpi_team.hpp"
#include "run_program.hpp"
#include "taut/team.hpp"
#include "taut/threads.hpp"
#include "terminal.hpp"

namespace {

/// Never deleted: a process may leave while others use it.
taut::app::MpiTeam* mpi_team = nullptr;

/// Ends with the others: the first tells the failure, and gives the code for all. That of another
/// would make mpirun end the first before it has told.
int end(int code, std::string_view message) noexcept {
    using namespace taut::app;
    try {
        // mpirun leaves a second between its request to stop and the end: the first waits for
        // nobody to tell what it kept.
        const bool is_told = code == interrupted;
        if (is_told) {
            tell("error", message);
        }
        const MpiTeam::Ending ending = mpi_team->agree_on_ending({code, std::string(message)});
        if (ending.code != 0 && !is_told) {
            tell("error", ending.message);
        }
        mpi_team->finish();
        return mpi_team->is_first() ? ending.code : 0;
    } catch (const std::exception& error) {
        tell("error", error.what());
        return numerical_failure;
    }
}

int run(int argc, char** argv) noexcept {
    using namespace taut::app;
    try {
        mpi_team = new MpiTeam;
        if (!mpi_team->is_first()) {
            be_silent();
        }
        int code = 0;
        const auto run_all = [&] {
            code = run_program(
                {.name = "taut-mpi",
                 .commands = {add_sample, add_train, add_compare, add_control},
                 .end = end},
                argc, argv);
        };
        // Unless --threads tells another number.
        taut::with_threads(mpi_team->fair_threads(), [&] { taut::with_team(*mpi_team, run_all); });
        return code;
    } catch (const std::exception& error) {
        tell("error", error.what());
        return numerical_failure;
    }
}

}  // namespace

int main(int argc, char** argv) {
    taut::app::prepare_streams();
    taut::app::leave(run(argc, argv));
}
