// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <string_view>

#include "command.hpp"
#include "memory_limit.hpp"
#include "run_program.hpp"
#include "terminal.hpp"

namespace {

/// Prints a failure in one line.
int end(int code, std::string_view message) noexcept {
#ifdef __wasi__
    if (code != 0 && taut::app::ran_out_of_memory()) {
        taut::app::print_message(
            "error", fmt::format("not enough memory{}", taut::app::memory_limit_note()));
        return taut::app::numerical_failure;
    }
#endif
    if (code != 0) {
        taut::app::print_message("error", message);
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace taut::app;
    prepare_streams();
    leave(
        run_program({.name = "taut",
                     .commands = {add_inspect, add_identify, add_plan, add_report},
                     .further_commands = {add_example, add_import, add_export, add_frame, add_form,
                                          add_survey, add_frequency, add_control, add_compare,
                                          add_reproduce, add_sample, add_train, add_app},
                     .end = end},
                    argc, argv));
}
