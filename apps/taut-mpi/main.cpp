// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// taut over the processes of a cluster. All of them run the same command; only the first prints and
// writes.

#include <exception>
#include <string>
#include <string_view>

#include "command.hpp"
#include "mpi_process_group.hpp"
#include "run_program.hpp"
#include "taut/process_group.hpp"
#include "taut/threads.hpp"
#include "terminal.hpp"

namespace {

/// Never deleted: a process may end while others use it.
taut::app::MpiProcessGroup* mpi_process_group = nullptr;

/// Ends together with the others: the first prints the failure and gives the exit code of all. That
/// of another would make mpirun end the first before it has printed.
int end(int code, std::string_view message) noexcept {
    using namespace taut::app;
    try {
        // mpirun leaves a second between its request to stop and the end, so the first does not
        // wait for the others before it prints what it kept.
        const bool is_printed = code == interrupted;
        if (is_printed) {
            print_message("error", message);
        }
        const MpiProcessGroup::Ending ending =
            mpi_process_group->agree_on_ending({code, std::string(message)});
        if (ending.code != 0 && !is_printed) {
            print_message("error", ending.message);
        }
        mpi_process_group->finish();
        return mpi_process_group->is_first() ? ending.code : 0;
    } catch (const std::exception& error) {
        print_message("error", error.what());
        return numerical_failure;
    }
}

int run(int argc, char** argv) noexcept {
    using namespace taut::app;
    try {
        mpi_process_group = new MpiProcessGroup;
        if (!mpi_process_group->is_first()) {
            be_silent();
        }
        int code = 0;
        const auto run_all = [&] {
            code = run_program({.name = "taut-mpi",
                                .commands = {add_sample, add_train, add_compare, add_control},
                                .end = end},
                               argc, argv);
        };
        // --threads overrides this.
        taut::with_threads(mpi_process_group->fair_threads(),
                           [&] { taut::with_process_group(*mpi_process_group, run_all); });
        return code;
    } catch (const std::exception& error) {
        print_message("error", error.what());
        return numerical_failure;
    }
}

}  // namespace

int main(int argc, char** argv) {
    taut::app::prepare_streams();
    taut::app::leave(run(argc, argv));
}
