// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "command.hpp"
#include "force_input.hpp"
#include "output_directory.hpp"
#include "plan_options.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "taut/process_group.hpp"
#include "taut/report/report_html.hpp"
#include "taut/results/control_files.hpp"
#include "taut/results/result_file.hpp"
#include "taut/study/control.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct ControlCommand : CommonOptions {
    std::string net;
    std::string directory;
    std::string prior = "uniform:5mm";
    UncertainOptions uncertain;
    std::string noise = "0.5mm";
    std::string drop = "10%";
    std::string actuator = "0mm";
    std::string stroke = "15mm";
    std::string tension;
    std::string confidence = "95%";
    std::string turn;
    std::string step;
    int draws = 200;
    int rounds = 4;
    int trials = 20;
    std::uint64_t seed = 1;
};

ControlSettings settings_of(const CableNet& net, const ControlCommand& command) {
    ControlSettings settings{.prior = parse_length_prior(command.prior),
                             .noise_std = parse_length(command.noise),
                             .hidden_part = parse_part(command.drop),
                             .actuator_std = parse_length(command.actuator),
                             .stroke = parse_length(command.stroke),
                             .confidence = parse_part(command.confidence),
                             .turn = parse_turn(command.turn, command.step),
                             .draws = command.draws,
                             .rounds = command.rounds,
                             .trials = command.trials,
                             .seed = command.seed};
    settings.uncertain = command.uncertain.assumed(net, command.net);
    if (!command.tension.empty()) {
        const TensionRange range = parse_tension_range(command.tension);
        if (range.has_part()) {
            throw std::invalid_argument(
                fmt::format("--tension is '{}', expected forces: parts of breaking loads are for "
                            "taut plan only",
                            command.tension));
        }
        settings.least_tension = range.least.value;
        settings.most_tension = std::isinf(range.most.value) ? 0.0 : range.most.value;
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
    std::vector<std::pair<std::string, std::string>> files{
        {"control.json", json}, {"control.csv", control_to_csv(records)}};
    if (has_report_viewer()) {
        files.emplace_back("report.html", report_html(parse_result(json, "control.json")));
    }
    write_files(directory, files);
    if (command.json) {
        say("{}", json);
        return;
    }
    say("uncertain besides the lengths ({}): {} (--uncertain)\n", settings.prior.to_string(),
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
    command.add_option("--prior", options->prior, "Prior of the length deviations")
        ->capture_default_str();
    add_uncertain_option(command, options->uncertain, assumes_site);
    command.add_option("--noise", options->noise, "Standard deviation of a surveyed coordinate")
        ->capture_default_str();
    command.add_option("--drop", options->drop, "Part of the free nodes that is not surveyed")
        ->capture_default_str();
    command
        .add_option("--actuator", options->actuator,
                    "Standard deviation of a stroke as made from the stroke as planned")
        ->capture_default_str();
    command
        .add_option("--stroke", options->stroke,
                    "Largest change of length of a turnbuckle since installation, either way")
        ->capture_default_str();
    command.add_option("--tension", options->tension,
                       "Limits of tension, 1.5kN..10kN (default: no edge slack)");
    command
        .add_option("--confidence", options->confidence,
                    "Probability with which limits hold, of plans on identified lengths")
        ->capture_default_str();
    command.add_option("--turn", options->turn, "Change of length by one turn, such as 5mm");
    command.add_option("--step", options->step, "Smallest part of a turn, such as 1/4")
        ->needs("--turn");
    command
        .add_option("--draws", options->draws, "Number of posterior samples of each identification")
        ->capture_default_str();
    command
        .add_option("--rounds", options->rounds, "Number of surveys, each followed by its turns")
        ->capture_default_str();
    command.add_option("--trials", options->trials, "Number of simulated nets")
        ->capture_default_str();
    add_seed_option(command, options->seed);
    set_action(command, options, run);
}

}  // namespace taut::app
