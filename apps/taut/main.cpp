// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "command.hpp"
#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/progress.hpp"
#include "taut/version.hpp"
#include "terminal.hpp"

namespace {

using taut::app::numerical_failure;
using taut::app::wrong_input;

/// The one line that tells a failure.
int fail(int code, std::string_view message) noexcept {
    taut::app::tell("error", message);
    return code;
}

int run(int argc, char** argv) {
    CLI::App program{
        "How long each cable of a tensioned net really is, from one survey of its form."};
    program.set_version_flag("--version", "taut " + std::string{taut::version()});
    program.require_subcommand(1);
    program.footer("taut COMMAND --help shows a command's options and an example.");
    taut::app::add_example(program);
    taut::app::add_import(program);
    taut::app::add_inspect(program);
    taut::app::add_form(program);
    taut::app::add_export(program);
    taut::app::add_sample(program);
    taut::app::add_train(program);
    taut::app::add_identify(program);
    taut::app::add_plan(program);
    taut::app::add_control(program);
    taut::app::add_reproduce(program);
    taut::app::add_compare(program);
    taut::app::add_trials(program);
    taut::app::add_report(program);
    taut::app::add_survey(program);
    const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
    if (argc > 1 && argv[1][0] != '-' &&
        std::ranges::find(commands, argv[1], &CLI::App::get_name) == commands.end()) {
        return fail(wrong_input,
                    fmt::format("'{}' is no command; taut --help lists them", argv[1]));
    }
    for (int i = 1; i < argc; ++i) {
        // An option without a value would be taken for one that was not given.
        const std::string_view word = argv[i];
        if (word.empty() || (word.starts_with("--") && word.find('=') == word.size() - 1)) {
            return fail(wrong_input, fmt::format("argument {} is empty: '{}'", i, word));
        }
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help, --version
            std::ostringstream text;
            program.exit(error, text);
            taut::app::print(text.str());
            return taut::app::standard_output_works()
                       ? 0
                       : fail(wrong_input, "standard output cannot be written");
        }
        return fail(wrong_input, error.what());
    }
    if (!taut::app::standard_output_works()) {
        return fail(wrong_input,
                    "the work is done and its files are written, but standard output cannot be");
    }
    return 0;
}

/// The exit code: what is thrown is told.
int run_told(int argc, char** argv) noexcept {
    try {
        taut::app::Interruption::watch();
        taut::app::remember_command_line(argc, argv);
        return run(argc, argv);
    } catch (const taut::Interrupted&) {
        return fail(taut::app::interrupted, "interrupted, nothing was written");
    } catch (const taut::app::SampleInterrupted& interruption) {
        return fail(taut::app::interrupted, interruption.what());
    } catch (const taut::InputError& error) {
        return fail(wrong_input, error.what());
    } catch (const taut::OutputError& error) {
        return fail(wrong_input, error.what());
    } catch (const std::invalid_argument& error) {
        return fail(wrong_input, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(wrong_input, error.what());
    } catch (const std::bad_alloc&) {
        taut::app::end_without_memory();  // as other threads may, too, at the same time
    } catch (const std::exception& error) {
        return fail(numerical_failure, error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    taut::app::prepare_streams();
    taut::app::leave(run_told(argc, argv));
}
