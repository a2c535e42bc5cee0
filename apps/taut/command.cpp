// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <charconv>
#include <filesystem>

#include "taut/io/file.hpp"

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

void check_output(const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code error;
        if (std::filesystem::equivalent(input, output, error)) {
            throw OutputError(output, "is an input of this command, expected another file");
        }
    }
    AtomicFile{output};
}

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
    // CLI11 takes a number beyond 64 bits for the largest one.
    const auto parse = [&seed](const std::string& text) {
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, seed);
        if (error != std::errc() || rest != end) {
            throw CLI::ValidationError(
                "--seed", "is '" + text + "', expected a whole number from 0 to 2^64 - 1");
        }
    };
    command.add_option_function<std::string>("--seed", parse, "Seed of the draws")
        ->default_str(std::to_string(seed));
}

std::string to_text(const nlohmann::ordered_json& document) {
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace taut::app
