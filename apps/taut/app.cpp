// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct AppOptions : CommonOptions {
    std::string output;
};

/// The page beside this program: where it is installed, in its folder on Windows, or where
/// scripts/app.sh leaves it.
std::filesystem::path app_page() {
    std::error_code error;
    const std::filesystem::path program = program_file();
    const std::filesystem::path folder = program.parent_path();
    for (const char* place : {"../share/taut/taut.html", "taut.html", "../../../app/taut.html"}) {
        if (!program.empty() && std::filesystem::exists(folder / place, error)) {
            return (folder / place).lexically_normal();
        }
    }
    throw std::invalid_argument(
        "this taut was installed without its page for browsers. 'make app' in a checkout of taut "
        "builds it, as build/app/taut.html, for the program and for what is installed afterwards");
}

void run(const AppOptions& options) {
    const std::filesystem::path page = app_page();
    check_outputs({options.output}, {page.string()});
    write_file(options.output, read_file(page));
    if (options.json) {
        say("{}\n", to_text({{"written", nlohmann::ordered_json::array({options.output})}}));
        return;
    }
    say("written to {}\n", options.output);
}

}  // namespace

void add_app(CLI::App& program) {
    auto options = std::make_shared<AppOptions>();
    CLI::App& command = add_command(
        program, "app", "Write taut as one HTML page, which works in a browser without a network",
        "  taut app -o taut.html", *options);
    add_output_option(command, options->output, "HTML file to write");
    set_action(command, options, run);
}

}  // namespace taut::app
