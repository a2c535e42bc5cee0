// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/progress.hpp"
#include "taut/version.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// Options of version 0.2 under their names of today: docs/compatibility.md.
/// @returns the arguments, each renamed one after a warning
std::vector<std::string> with_new_names(int argc, char** argv) {
    struct Renamed {
        std::string_view before, now;
    };
    constexpr std::array<Renamed, 4> renamed{{{"--law", "--prior"},
                                              {"--unknown", "--uncertain"},
                                              {"--further", "--suggest-adjustable"},
                                              {"--survey-first", "--suggest-targets"}}};
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const std::string_view name = word.substr(0, word.find('='));
        const auto* const found = std::ranges::find(renamed, name, &Renamed::before);
        if (found == renamed.end()) {
            words.emplace_back(word);
            continue;
        }
        const bool was_all = found->before == "--unknown";  // all else was exact then
        tell("warning", fmt::format("{} is now {}{}", found->before,
                                    was_all ? "--uncertain none " : "", found->now));
        if (was_all) {
            words.emplace_back("--uncertain=none");
        }
        words.push_back(fmt::format("{}{}", found->now, word.substr(name.size())));
    }
    return words;
}

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
        std::vector<std::string> words = with_new_names(argc, argv);
        std::ranges::reverse(words);  // as CLI11 takes them
        parser.parse(std::move(words));
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
