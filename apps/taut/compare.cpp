// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "command.hpp"
#include "comparison_table.hpp"
#include "force_input.hpp"
#include "memory_limit.hpp"
#include "memory_needs.hpp"
#include "net_summary.hpp"
#include "output_directory.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/cable_runs.hpp"
#include "taut/net/units.hpp"
#include "taut/process_group.hpp"
#include "taut/results/comparison_files.hpp"
#include "taut/study/comparison.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct CompareOptions : CommonOptions {
    std::string net;
    std::string directory;
    UncertainOptions uncertain;
    ComparisonSettings comparison;
};

/// Parses a list with commas. `parse` throws std::invalid_argument for a wrong entry.
template <class Parse>
auto parse_list(const std::string& text, const std::string& option, const std::string& expected,
                Parse parse) {
    std::vector<decltype(parse(text))> values;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        const std::string entry = text.substr(begin, end - begin);
        try {
            values.push_back(parse(entry));
        } catch (const std::invalid_argument&) {
            throw std::invalid_argument(
                fmt::format("{} has the entry '{}', expected {}", option, entry, expected));
        }
        begin = end + 1;
    }
    return values;
}

std::vector<double> parse_noises(const std::string& list) {
    return parse_list(list, "--noise", "standard deviations as in 0,0.1mm,0.5mm", parse_length);
}

std::vector<int> parse_training(const std::string& list) {
    return parse_list(list, "--training", "whole numbers of at least 2 as in 100,950",
                      [](const std::string& text) {
                          int count = 0;
                          const char* const end = text.data() + text.size();
                          const auto [rest, error] = std::from_chars(text.data(), end, count);
                          if (error != std::errc() || rest != end) {
                              throw std::invalid_argument("not a number");
                          }
                          return count;
                      });
}

std::vector<double> parse_hidden(const std::string& list) {
    return parse_list(list, "--hidden", "parts from 0% to below 100% as in 0,10%",
                      [](const std::string& text) { return text == "0" ? 0.0 : parse_part(text); });
}

void run(const CompareOptions& given) {
    CompareOptions options = given;
    options.comparison.check();
    const CableNet net = read_net(options.net).net;
    naming_file(options.net, [&] { refuse_sliding(net, "training"); });
    options.comparison.uncertain = options.uncertain.given(net, options.net);
    const int most = std::ranges::max(options.comparison.training_samples);
    require_memory(training_memory(net, most), fmt::format("{} training samples", most));
    const std::filesystem::path directory(options.directory);
    if (process_group().is_first()) {
        check_output_directory(directory, {"comparison.json", "comparison.csv", "report.html"},
                               {options.net});
    }

    const Comparison comparison = [&] {
        ProgressLine line(options.quiet);
        return compare_methods(net, options.comparison, line.progress());
    }();
    if (!process_group().is_first()) {
        return;
    }
    const std::string json = comparison_to_json(comparison, run_record());
    write_with_report(directory, "comparison.json", json,
                      {{"comparison.csv", comparison_to_csv(comparison)}});

    if (options.json) {
        say("{}", json);
        return;
    }
    say("{}\n{}\n", counts_text(net), comparison_table(comparison));
    say("written to {}: comparison.json, comparison.csv\nreport: {}\n", options.directory,
        report_text(directory));
}

}  // namespace

void add_compare(CLI::App& program) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App& command = add_command(
        program, "compare",
        "Compare the methods of identification with each other and with the Cramér-Rao bound",
        "  taut compare net.json -o comparison\n"
        "  taut compare net.json -o comparison --noise 0,0.5mm --training 100,300 --hidden 0,20%\n"
        "\nThe comparison varies one setting at a time, not all combinations: the noise of the "
        "survey,\nat 950 training samples (or the most, where 950 is none of them); the training "
        "samples, at\nnoise 0 and 0.5 mm (or the largest); the part of hidden nodes, at 950 "
        "samples "
        "and 0.5 mm.\n--uncertain adds nets with model errors, which the methods know of or not. "
        "--epochs adds\nseveral surveys of each net.",
        *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("-o,--output", options->directory, "Directory to write into")->required();
    ComparisonSettings& comparison = options->comparison;
    comparison.hidden_parts = {0.0, 0.1};
    add_parsed(command, "--noise", comparison.noises, parse_noises,
               "Standard deviations of normal noise on every coordinate",
               "0,0.1mm,0.2mm,0.5mm,1mm,2mm");
    add_parsed(command, "--training", comparison.training_samples, parse_training,
               "Numbers of training samples; 3000 take a minute and 2 GB", "100,200,500,950,2000");
    add_parsed(command, "--hidden", comparison.hidden_parts, parse_hidden,
               "Parts of the free nodes that are not surveyed", "0,10%");
    command
        .add_option("--surveys", comparison.surveys,
                    "Number of surveys of each kind, of samples not used in training")
        ->capture_default_str();
    add_parsed(command, "--prior", comparison.prior, parse_length_prior,
               "Prior of the length deviations", "uniform:5mm");
    add_uncertain_option(command, options->uncertain);
    command
        .add_option("--epochs", comparison.epochs,
                    "Largest number of surveys of each net that are used together: of the same "
                    "form, and with every turnbuckle turned by up to 5 mm in between")
        ->capture_default_str();
    add_seed_option(command, comparison.seed);
    set_action(command, options, run);
}

}  // namespace taut::app
