// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "run_record.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/progress.hpp"
#include "taut/version.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// Shows the options of a command under headings in a fixed order: CLI11 has them in the order in
/// which each heading is first used.
class GroupedHelp : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override {
        std::string text =
            make_description(app) + make_usage(app, std::move(name)) + make_positionals(app);
        for (const std::string group : {"Options", heading::input, heading::known, heading::limits,
                                        heading::output, heading::advanced}) {
            const auto options = app->get_options([&](const CLI::Option* option) {
                return option->get_group() == group && option->nonpositional();
            });
            if (!options.empty()) {
                text += make_group(group, false, options);
            }
        }
        return text + make_subcommands(app, mode) + '\n' + make_footer(app);
    }
};

/// Options of version 0.2 under their present names: docs/compatibility.md.
/// @return the arguments, with one warning for each old name
std::vector<std::string> with_new_names(int argc, char** argv) {
    struct Renamed {
        std::string_view before, now;
    };
    constexpr std::array<Renamed, 4> renamed{{{"--law", "--prior"},
                                              {"--unknown", "--uncertain"},
                                              {"--further", "--suggest-adjustable"},
                                              {"--survey-first", "--suggest-targets"}}};
    std::vector<std::string> words;
    std::set<std::string_view> warned;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const std::string_view name = word.substr(0, word.find('='));
        const auto* const found = std::ranges::find(renamed, name, &Renamed::before);
        if (found == renamed.end()) {
            words.emplace_back(word);
            continue;
        }
        const bool was_all = found->before == "--unknown";  // everything else was exact then
        if (warned.insert(found->before).second) {
            print_message("warning", fmt::format("{} is now {}{}", found->before,
                                                 was_all ? "--uncertain none " : "", found->now));
        }
        if (was_all) {
            words.emplace_back("--uncertain=none");
        }
        words.push_back(fmt::format("{}{}", found->now, word.substr(name.size())));
    }
    return words;
}

/// "--total-stroke" of the field "total_stroke".
std::string option_of(std::string field) {
    std::ranges::replace(field, '_', '-');
    return "--" + field;
}

int run(const Program& program, int argc, char** argv) {
    CLI::App parser{
        "Estimates the unstressed length of each cable of a tensioned net from one survey of its "
        "form.",
        program.name};
    parser.formatter(std::make_shared<GroupedHelp>());
    parser.set_version_flag("--version", program.name + " " + std::string{version()});
    parser.require_subcommand(1);
    parser.footer(program.name + " COMMAND --help shows a command's options and an example.");
    for (const auto& add_command : program.commands) {
        add_command(parser);
    }
    for (CLI::App* command : parser.get_subcommands({})) {
        command->group("Commands");
    }
    for (const auto& add_command : program.further_commands) {
        add_command(parser);
    }
    const auto commands = parser.get_subcommands({});
    for (size_t k = program.commands.size(); k < commands.size(); ++k) {
        commands[k]->group("Further commands");
    }
    if (argc > 1 && argv[1][0] != '-' &&
        std::ranges::find(commands, argv[1], &CLI::App::get_name) == commands.end()) {
        return program.end(wrong_input, fmt::format("'{}' is not a command; {} --help lists them",
                                                    argv[1], program.name));
    }
    for (int i = 1; i < argc; ++i) {
        // CLI11 takes an option with an empty value for one that was not given.
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
        return fail(interrupted, "interrupted; nothing was written");
    } catch (const SampleInterrupted& interruption) {
        return fail(interrupted, interruption.what());
    } catch (const InputError& error) {
        return fail(wrong_input, error.what());
    } catch (const OutputError& error) {
        return fail(wrong_input, error.what());
    } catch (const RequestError& error) {
        return fail(wrong_input, option_of(error.field()) + " " + error.problem());
    } catch (const std::invalid_argument& error) {
        return fail(wrong_input, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(wrong_input, error.what());
    } catch (const std::bad_alloc&) {
#ifdef __wasi__
        return fail(numerical_failure, "not enough memory");
#else
        end_without_memory();  // as other threads may, too, at the same time
#endif
    } catch (const std::runtime_error& error) {
        return fail(numerical_failure, error.what());
    } catch (const std::exception&) {
        // Whatever taut throws on purpose is caught above. The words of any other exception name
        // nothing that the user knows.
        return fail(numerical_failure,
                    "internal error. Please report it with the files of this command: " +
                        run_record().command);
    }
}

}  // namespace taut::app
