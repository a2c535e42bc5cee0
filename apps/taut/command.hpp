// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/files/input_error.hpp"

/// One file a subcommand: each adds itself to the program, with its options and what it runs.
namespace taut::app {

/// An outcome of the numbers that is not what was asked for: exit code 1.
class NumericalFailure : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Options that every subcommand has.
struct CommonOptions {
    int threads = 0;     ///< 0: all
    std::string memory;  ///< limit, "8GiB"; empty: none
    bool quiet = false;
    bool json = false;
};

/// Headings of a command's help, in the order in which run_program() shows them. Options that
/// everybody needs have none of these and come first, under "Options".
namespace heading {
inline constexpr const char* input = "Input";
inline constexpr const char* known = "What is known";
inline constexpr const char* limits = "Limits";
inline constexpr const char* output = "Output";
inline constexpr const char* advanced = "Advanced";
}  // namespace heading

/// Adds a subcommand with the common options, and worked examples under its help.
CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::string& example, CommonOptions& options);

/// Does the work on the threads and within the memory that the options give.
void run_within(const CommonOptions& options, const std::function<void()>& work);

/// Sets what the command does with its options.
template <class Options>
void set_action(CLI::App& command, const std::shared_ptr<Options>& options,
                void (*run)(const Options&)) {
    command.callback([options, run] { run_within(*options, [&] { run(*options); }); });
}

/// An option whose text is read when it is given, by parse_length() for example.
/// @param value lives as long as the command
/// @param shown its default, for the help; empty: none
template <class Value, class Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Value& value, Parse parse,
                        const std::string& description, const std::string& shown = "") {
    CLI::Option* const option = command.add_option_function<std::string>(
        name, [&value, parse](const std::string& text) { value = parse(text); }, description);
    return shown.empty() ? option : option->default_str(shown);
}

/// The same of an option that may be repeated.
template <class Value, class Parse>
CLI::Option* add_each_parsed(CLI::App& command, const std::string& name, std::vector<Value>& values,
                             Parse parse, const std::string& description) {
    return command.add_option_function<std::vector<std::string>>(
        name,
        [&values, parse](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
                values.push_back(parse(text));
            }
        },
        description);
}

/// Does something with what a file holds. What the library refuses becomes an InputError that names
/// the file.
template <class Action>
auto naming_file(const std::string& file, const Action& action) {
    try {
        return action();
    } catch (const std::invalid_argument& error) {
        throw InputError(file, "", error.what());
    }
}

/// -o, --output of a command that always writes a file.
void add_output_option(CLI::App& command, std::string& output, const std::string& description);

/// Refuses an output that is an input or another output, and "-", which would be a file of that
/// name. Every output passes here. Empty names are options that were not given.
/// @throws OutputError
void refuse_outputs(const std::vector<std::string>& outputs,
                    const std::vector<std::string>& inputs);

/// The same, and an output that cannot be written: before the work, not after it.
/// @throws OutputError
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// --seed: a whole number from 0 to 2^64 - 1.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// Notes temporary files beside an output that a killed run left there.
void note_left_files(const std::filesystem::path& output);

/// Each warning on a line of standard error, "taut: warning: net.json: ...".
void warn(const std::string& file, const std::vector<std::string>& warnings);

/// Notes a file without a digest, in which damage would go unnoticed.
void note_digest(const std::string& file, bool has_digest);

/// A document as it is printed; bytes that are no UTF-8, as a file's name may hold, are replaced.
std::string to_text(const nlohmann::ordered_json& document);

void add_app(CLI::App& program);
void add_example(CLI::App& program);
void add_import(CLI::App& program);
void add_inspect(CLI::App& program);
void add_export(CLI::App& program);
void add_form(CLI::App& program);
void add_frame(CLI::App& program);
void add_frequency(CLI::App& program);
void add_sample(CLI::App& program);
void add_train(CLI::App& program);
void add_identify(CLI::App& program);
void add_control(CLI::App& program);
void add_plan(CLI::App& program);
void add_reproduce(CLI::App& program);
void add_survey(CLI::App& program);
void add_compare(CLI::App& program);
void add_report(CLI::App& program);

}  // namespace taut::app
