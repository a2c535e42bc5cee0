// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>

#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/progress.hpp"
#include "taut/version.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

int run(const Program& program, int argc, char** argv) {
    CLI::App parser{
        "How long each cable of a tensioned net really is, from one survey of its form."};
    parser.set_version_flag("--version", program.name + " " + std::string{version()});
    parser.require_subcommand(1);
    parser.footer(program.name + " COMMAND --help shows a command's options and an example.");
    for (const auto& add_command : program.commands) {
        add_command(parser);
    }
    const auto commands = parser.get_subcommands([](const CLI::App*) { return true; });
    if (argc > 1 && argv[1][0] != '-' &&
        std::ranges::find(commands, argv[1], &CLI::App::get_name) == commands.end()) {
        return program.end(wrong_input, fmt::format("'{}' is no command; {} --help lists them",
                                                    argv[1], program.name));
    }
    for (int i = 1; i < argc; ++i) {
        // An option without a value would be taken for one that was not given.
        const std::string_view word = argv[i];
        if (word.empty() || (word.starts_with("--") && word.find('=') == word.size() - 1)) {
            return program.end(wrong_input, fmt::format("argument {} is empty: '{}'", i, word));
        }
    }
    try {
        parser.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help, --version
            std::ostringstream text;
            parser.exit(error, text);
            app::print(text.str());
            return standard_output_works()
                       ? program.end(0, "")
                       : program.end(wrong_input, "standard output cannot be written");
        }
        return program.end(wrong_input, error.what());
    }
    if (!standard_output_works()) {
        return program.end(
            wrong_input,
            "the work is done and its files are written, but standard output cannot be");
    }
    return program.end(0, "");
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) noexcept {
    const auto fail = program.end;
    try {
        Interruption::watch();
        remember_command_line(argc, argv);
        return run(program, argc, argv);
    } catch (const Interrupted&) {
        return fail(interrupted, "interrupted, nothing was written");
    } catch (const SampleInterrupted& interruption) {
        return fail(interrupted, interruption.what());
    } catch (const InputError& error) {
        return fail(wrong_input, error.what());
    } catch (const OutputError& error) {
        return fail(wrong_input, error.what());
    } catch (const std::invalid_argument& error) {
        return fail(wrong_input, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(wrong_input, error.what());
    } catch (const std::bad_alloc&) {
        end_without_memory();  // as other threads may, too, at the same time
    } catch (const std::runtime_error& error) {
        return fail(numerical_failure, error.what());
    } catch (const std::exception&) {
        // taut says in its own words what is wrong. All else comes of a fault in it, and names
        // nothing that its user knows.
        return fail(numerical_failure,
                    "a fault of the program itself ended this command, which is to be "
                    "reported with its files: " +
                        run_record().command);
    }
}

}  // namespace taut::app
