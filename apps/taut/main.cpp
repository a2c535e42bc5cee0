// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <string_view>

#include "command.hpp"
#include "run_program.hpp"
#include "terminal.hpp"

namespace {

/// The one line that tells a failure.
int end(int code, std::string_view message) noexcept {
    if (code != 0) {
        taut::app::tell("error", message);
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace taut::app;
    prepare_streams();
    leave(run_program({.name = "taut",
                       .commands = {add_example, add_import, add_inspect, add_form, add_export,
                                    add_sample, add_train, add_identify, add_plan, add_control,
                                    add_reproduce, add_compare, add_report, add_survey},
                       .end = end},
                      argc, argv));
}
