// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "command.hpp"
#include "output_directory.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/results/settling_files.hpp"
#include "taut/study/settling.hpp"
#include "taut/study/settling_nets.hpp"
#include "taut/team.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct TrialsOptions : CommonOptions {
    std::vector<std::string> nets;
    std::string directory;
    SettlingSettings settings;
};

std::vector<CableNet> nets_of(const TrialsOptions& options) {
    if (options.nets.empty()) {
        return settling_nets();
    }
    std::vector<CableNet> nets;
    nets.reserve(options.nets.size());
    for (const std::string& file : options.nets) {
        nets.push_back(read_net(file).net);
    }
    return nets;
}

constexpr const char* trials_row =
    "{:<30}{:>8}{:>9}{:>9}{:>9}{:>7}{:>10}{:>10}{:>10}{:>8}{:>8}{:>8}\n";

std::string percent_text(double part, double whole) {
    return whole > 0.0 ? fmt::format("{:.1f}", 100.0 * part / whole) : "-";
}

std::string table(const std::vector<SettlingRecord>& records) {
    std::string text = fmt::format(trials_row, "", "", "", "median", "largest", "", "inside",
                                   "tensions", "inside", "called", "of them", "slack,") +
                       fmt::format(trials_row, "net", "surveys", "settled", "[ms]", "[ms]", "ratio",
                                   "95 % [%]", "told [%]", "95 % [%]", "slack", "taut", "missed");
    for (const SettlingRecord& record : records) {
        const double median = record.median_seconds();
        const double largest = record.largest_seconds();
        const auto told = static_cast<double>(
            std::ranges::count_if(record.outcomes, [](const SettlingOutcome& outcome) {
                return outcome.settled && outcome.tensions_told > 0;
            }));
        text += fmt::format(
            trials_row, record.net, record.outcomes.size(), record.settled(),
            fmt::format("{:.1f}", 1e3 * median), fmt::format("{:.1f}", 1e3 * largest),
            median > 0.0 ? fmt::format("{:.1f}", largest / median) : "-",
            percent_text(record.coverage(), record.settled() > 0 ? 1.0 : 0.0),
            percent_text(told, record.settled()),
            percent_text(record.sum(&SettlingOutcome::tensions_inside),
                         record.sum(&SettlingOutcome::tensions_told)),
            record.sum(&SettlingOutcome::slack_called), record.sum(&SettlingOutcome::taut_as_slack),
            record.sum(&SettlingOutcome::slack_as_taut));
    }
    return text;
}

/// The numbers of a reliability diagram, over all nets.
std::string reliability_table(const std::vector<SettlingRecord>& records) {
    SlackReliability reliability;
    for (const SettlingRecord& record : records) {
        reliability.add(record.slack_reliability());
    }
    constexpr const char* format = "{:<24}{:>10}{:>16}{:>16}\n";
    std::string text =
        fmt::format(format, "slack, probability told", "edges", "told, mean [%]", "are slack [%]");
    for (const SlackReliability::Bin& bin : reliability.bins()) {
        text += fmt::format(
            format,
            bin.up_to > 0.0 ? fmt::format("{:g} to {:g}", bin.above, bin.up_to) : std::string("0"),
            bin.edges, percent_text(bin.told, bin.edges),
            bin.edges > 0 ? fmt::format("{:.3g}", 100.0 * bin.slack / bin.edges)
                          : std::string("-"));
    }
    return text;
}

std::string failures(const std::vector<SettlingRecord>& records) {
    std::string text;
    for (const SettlingRecord& record : records) {
        for (const SettlingOutcome& outcome : record.outcomes) {
            if (!outcome.settled) {
                text += fmt::format("  {}, survey {}: {}\n", record.net, outcome.number,
                                    outcome.message);
            }
        }
    }
    return text.empty() ? "All settled.\n" : "Not settled:\n" + text;
}

void run(const TrialsOptions& options) {
    options.settings.check();
    const std::vector<CableNet> nets = nets_of(options);
    const std::filesystem::path directory(options.directory);
    if (team().is_first()) {
        check_output_directory(directory, {"trials.json", "trials.csv"}, options.nets);
    }
    const std::vector<SettlingRecord> records = [&] {
        ProgressLine line(options.quiet);
        std::vector<SettlingRecord> result;
        result.reserve(nets.size());
        for (const CableNet& net : nets) {
            result.push_back(try_settling(net, options.settings,
                                          line.progress().part(static_cast<int>(result.size()),
                                                               static_cast<int>(nets.size()))));
        }
        return result;
    }();
    if (!team().is_first()) {
        return;
    }
    const std::string json = settling_to_json(records, options.settings, run_record());
    write_files(directory, {{"trials.json", json},
                            {"trials.csv", settling_to_csv(records, options.settings)}});
    if (options.json) {
        say("{}", json);
        return;
    }
    say("{}\n{}\n{}written to {}: trials.json, trials.csv\n", table(records),
        reliability_table(records), failures(records), options.directory);
}

}  // namespace

void add_trials(CLI::App& program) {
    auto options = std::make_shared<TrialsOptions>();
    CLI::App& command = add_command(
        program, "trials",
        "Try on random surveys, whose truth is known, whether maximum a posteriori settles.\n"
        "Each survey draws its prior (uniform, 2 or 5 mm), its noise (0.05 to 2 mm), a tenth of "
        "the\n"
        "nodes hidden or none, and 5 % of the targets off by 10 to 50 standard deviations or "
        "none.\n"
        "It follows from net, seed and its number: --first N --surveys 1 repeats survey N.",
        "  taut trials -o trials --surveys 10\n"
        "  taut trials net.json -o one --first 17 --surveys 1",
        *options);
    command.add_option("NET", options->nets, "Net files (default: twelve nets, soft and stiff)");
    command.add_option("-o,--output", options->directory, "Directory to write into")->required();
    command.add_option("--surveys", options->settings.surveys, "Surveys of each net")
        ->capture_default_str();
    command.add_option("--first", options->settings.first, "Number of the first survey")
        ->capture_default_str();
    add_seed_option(command, options->settings.seed);
    set_action(command, options, run);
}

}  // namespace taut::app
