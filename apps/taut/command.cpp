// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "command.hpp"

namespace taut::app {

CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::string& example, CommonOptions& options) {
    CLI::App& command = *program.add_subcommand(name, description);
    command.footer("Example:\n" + example);
    command.add_option("--threads", options.threads, "Threads to use (default: all)")
        ->check(CLI::Range(1, 1024));
    command.add_flag("--json", options.json, "Write the outcome to standard output as JSON");
    command.add_flag("--quiet", options.quiet, "No progress on standard error");
    return command;
}

}  // namespace taut::app
