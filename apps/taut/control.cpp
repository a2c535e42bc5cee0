// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <filesystem>

#include "command.hpp"
#include "force_input.hpp"
#include "output_directory.hpp"
#include "plan_options.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "taut/process_group.hpp"
#include "taut/results/control_files.hpp"
#include "taut/study/control.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ControlCommand : CommonOptions {
    std::string net;
    std::string directory;
    ControlSettings settings{.prior = {}, .turn = {}};
    UncertainOptions uncertain;
    std::string tension;
};

ControlSettings settings_of(const CableNet& net, const ControlCommand& command) {
    ControlSettings settings = command.settings;
    settings.uncertain = command.uncertain.assumed(net, command.net);
    if (!command.tension.empty()) {
        const TensionRange range = parse_tension_range(command.tension);
        check_tension_range(range);
        if (range.group || (range.least && range.least->is_part) ||
            (range.most && range.most->is_part)) {
            throw std::invalid_argument(
                fmt::format("--tension is '{}', expected forces: groups and parts of breaking "
                            "loads are for taut plan only",
                            command.tension));
        }
        settings.least_tension = range.least.value_or(TensionBound{}).value;
        settings.most_tension = range.most.value_or(TensionBound{}).value;  // 0: no limit
    }
    return settings;
}

void print_record(const ControlRecord& record, const ControlSettings& settings) {
    for (int round = record.strategy == ControlStrategy::truth ? 0 : 1;
         round <= (record.strategy == ControlStrategy::once ? 1 : settings.rounds); ++round) {
        const ControlRecord::Round after = record.after(round);
        say("{:<16}{:>6}{:>10.2f}{:>8.1f}{:>12.2f}{:>8.1f}{:>9.2f}{:>12.2f}{:>8.2f}{:>10}"
            "{:>10}{:>10}\n",
            round == 0 ? "as built" : to_string(record.strategy), round, 1e3 * after.mean,
            1e3 * after.max, 1e3 * after.normal_mean, 1e3 * after.normal_max,
            1e3 * after.normal_rmse, 1e-3 * after.least_tension, 1e-3 * after.most_tension,
            fmt::format("{}/{}", after.broken_trials, settings.trials),
            after.broken_trials > 0 ? fmt::format("{:.1f}", 1e2 * after.worst_excess) : "-",
            after.failed);
    }
}

void run(const ControlCommand& command) {
    const CableNet net = read_net(command.net).net;
    const ControlSettings settings = settings_of(net, command);
    const std::filesystem::path directory(command.directory);
    if (process_group().is_first()) {
        check_output_directory(directory, {"control.json", "control.csv", "report.html"},
                               {command.net});
    }
    ProgressLine line(command.quiet);
    const std::vector<ControlRecord> records = simulate_control(net, settings, line.progress());
    if (!process_group().is_first()) {
        return;
    }
    const std::string json = control_to_json(records, net, settings, run_record());
    write_with_report(directory, "control.json", json, {{"control.csv", control_to_csv(records)}});
    if (command.json) {
        say("{}", json);
        return;
    }
    say("uncertain besides the lengths ({}): {} (--uncertain)\n", to_string(settings.prior),
        to_string(settings.uncertain));
    say("{:<16}{:>6}{:>18}{:>29}{:>20}{:>10}{:>10}{:>10}\n", "", "", "from target [mm]",
        "along its normal [mm]", "tension [kN]", "limits", "by at", "not");
    say("{:<16}{:>6}{:>10}{:>8}{:>12}{:>8}{:>9}{:>12}{:>8}{:>10}{:>10}{:>10}\n", "planned on",
        "round", "mean", "max", "mean", "max", "RMS", "min", "max", "broken", "most [%]",
        "planned");
    for (const ControlRecord& record : records) {
        print_record(record, settings);
    }
    say("written to {}: control.json, control.csv\nreport: {}\n", command.directory,
        report_text(directory));
}

}  // namespace

void add_control(CLI::App& program) {
    auto options = std::make_shared<ControlCommand>();
    CLI::App& command = add_command(
        program, "control",
        "Simulate whole jobs of survey, identification, plan and turns, beside the same with true\n"
        "lengths and with the design only",
        "  taut control net.json -o control --tension 1.5kN..10kN --trials 20", *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("-o,--output", options->directory, "Directory to write into")->required();
    ControlSettings& settings = options->settings;
    add_parsed(command, "--prior", settings.prior, parse_length_prior,
               "Prior of the length deviations", "uniform:5mm");
    add_uncertain_option(command, options->uncertain, assumes_site);
    add_parsed(command, "--noise", settings.noise_std, parse_length,
               "Standard deviation of a surveyed coordinate", "0.5mm");
    add_parsed(command, "--drop", settings.hidden_part, parse_part,
               "Part of the free nodes that is not surveyed", "10%");
    add_parsed(command, "--actuator", settings.actuator_std, parse_length, actuator_help, "0mm");
    add_parsed(command, "--stroke", settings.stroke, parse_length,
               "Largest change of length of a turnbuckle since installation, either way", "15mm");
    command.add_option("--tension", options->tension,
                       "Limits of tension, 1.5kN..10kN (default: no edge slack)");
    add_parsed(command, "--confidence", settings.confidence, parse_part,
               "Probability with which limits hold, of plans on identified lengths", "95%");
    add_turn_options(command, settings.turn, "Smallest part of a turn, such as 1/4");
    command
        .add_option("--draws", settings.draws, "Number of posterior samples of each identification")
        ->capture_default_str();
    command
        .add_option("--rounds", settings.rounds, "Number of surveys, each followed by its turns")
        ->capture_default_str();
    command.add_option("--trials", settings.trials, "Number of simulated nets")
        ->capture_default_str();
    add_seed_option(command, settings.seed);
    set_action(command, options, run);
}

}  // namespace taut::app
