// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "memory_limit.hpp"
#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/process_group.hpp"
#include "taut/threads.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// Processes that share the work must have been given the same arguments.
void require_same_arguments() {
    if (process_group().size() == 1) {
        return;
    }
    const std::vector<std::string> all =
        process_group().gather(run_record().command, Receivers::all);
    const auto other = std::ranges::find_if(
        all, [&](const std::string& command) { return command != all.front(); });
    if (other != all.end()) {
        throw std::invalid_argument(
            fmt::format("process {} of {} has other arguments than the first, expected the same",
                        other - all.begin(), all.size()));
    }
}

}  // namespace

CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::string& example, CommonOptions& options) {
    CLI::App& command = *program.add_subcommand(name, description);
    command.footer("Example:\n" + example);
    command.add_flag("--json", options.json, "Print the result as JSON")->group(heading::output);
    command.add_flag("--quiet", options.quiet, "Show no progress on standard error")
        ->group(heading::output);
    command.add_option("--threads", options.threads, "Number of threads (default: all)")
        ->check(CLI::Range(1, 1024))
        ->group(heading::advanced);
    command
        .add_option("--memory", options.memory,
                    "Memory limit of this process, such as 8GiB. Work known to need more is "
                    "refused before it starts (default: none)")
        ->group(heading::advanced);
    return command;
}

void run_within(const CommonOptions& options, const std::function<void()>& work) {
    require_same_arguments();
    const auto within = [&] {
        if (!options.memory.empty()) {
            limit_memory(options.memory, max_threads());
        }
        work();
    };
    if (options.threads > 0) {
        with_threads(options.threads, within);
    } else {
        within();
    }
}

void add_output_option(CLI::App& command, std::string& output, const std::string& description) {
    command.add_option("-o,--output", output, description)
        ->required()
        ->check([](const std::string& name) { return name.empty() ? "has no file name" : ""; });
}

void refuse_outputs(const std::vector<std::string>& outputs,
                    const std::vector<std::string>& inputs) {
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        const auto is_output = [&](const std::string& other) {
            return !other.empty() && is_same_file(other, *output);
        };
        if (output->empty()) {
            continue;
        }
        if (*output == "-") {
            throw OutputError(*output,
                              "results go to files, not to standard output. Name a file, or ./- "
                              "for one that is called '-'");
        }
        if (std::ranges::any_of(inputs, is_output)) {
            throw OutputError(*output, "is an input of this command, expected another file");
        }
        if (std::any_of(outputs.begin(), output, is_output)) {
            throw OutputError(*output, "is to be written twice, expected two files");
        }
    }
}

void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::string>& inputs) {
    refuse_outputs(outputs, inputs);
    for (const std::string& output : outputs) {
        if (!output.empty()) {
            AtomicFile{output};
            note_left_files(output);
        }
    }
}

void note_left_files(const std::filesystem::path& output) {
    for (const std::filesystem::path& left : left_temporary_files(output)) {
        print_message("note",
                      left.string() +
                          ": was left by a run that has ended on this machine. Remove it unless a "
                          "run on another machine writes here");
    }
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
    command.add_option_function<std::string>("--seed", parse, "Seed of the random numbers")
        ->default_str(std::to_string(seed))
        ->group(heading::advanced);
}

void warn(const std::string& file, const std::vector<std::string>& warnings) {
    for (const std::string& line : warnings) {
        print_message("warning", fmt::format("{}: {}", file, line));
    }
}

void note_digest(const std::string& file, bool has_digest) {
    if (!has_digest) {
        print_message(
            "note", file +
                        ": has no digest of its content, like all files of taut 0.2.0 and before. "
                        "Damage to it would not be noticed");
    }
}

std::string to_text(const nlohmann::ordered_json& document) {
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace taut::app
