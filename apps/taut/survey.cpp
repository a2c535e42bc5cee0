// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <charconv>

#include "command.hpp"
#include "net_summary.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/survey/noise_check.hpp"
#include "taut/survey/simulation.hpp"

namespace taut::app {
namespace {

struct SurveySimulationOptions : CommonOptions {
    std::string net;
    std::string form;
    std::string noise;
    std::string drop = "0%";
    std::string frame = "net";
    std::string output;
    SurveySimulation simulation;
};

/// "10%" as 0.1.
double parse_part(const std::string& text) {
    double percent = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, percent);
    if (error != std::errc() || std::string_view(rest, end - rest) != "%" ||
        !(percent >= 0.0 && percent < 100.0)) {
        throw std::invalid_argument(
            fmt::format("--drop is '{}', expected a part from 0% to below 100%", text));
    }
    return percent / 100.0;
}

void run(SurveySimulationOptions options) {
    const auto threads = options.limit_threads();
    SurveySimulation& simulation = options.simulation;
    simulation.noise_std = parse_noise(options.noise);
    simulation.dropped_part = parse_part(options.drop);
    simulation.random_frame = options.frame == "random";
    const CableNet net = read_net(options.net).net;
    refuse_absurd_noise(net, simulation.noise_std);
    const std::vector<std::string> warnings = noise_warnings(net, simulation.noise_std);
    const Points form = read_form(net, options.form);
    check_outputs({options.output}, {options.net, options.form});
    const std::vector<SurveyPoint> points = simulate_survey(net, form, simulation);
    write_file(options.output, survey_to_csv(points));
    warn("--noise", warnings);
    const auto free_points = points.size() - net.supports().size();
    if (options.json) {
        fmt::print("{}\n", to_text({{"format", "taut-survey-simulation"},
                                    {"version", 1},
                                    {"net", counts_json(net)},
                                    {"surveyed_free_nodes", free_points},
                                    {"surveyed_supports", net.supports().size()},
                                    {"noise", simulation.noise_std},
                                    {"named", !simulation.shuffled},
                                    {"frame", options.frame},
                                    {"seed", simulation.seed},
                                    {"warnings", warnings},
                                    {"output", options.output}}));
        return;
    }
    fmt::print(
        "{}\n{} of {} free nodes surveyed{}, and {} supports by their names; noise {:.4g} mm"
        "{}\nwritten to {}\n",
        counts_text(net), free_points, net.free_node_count(),
        simulation.shuffled ? ", without names and in any order" : "", net.supports().size(),
        1e3 * simulation.noise_std, simulation.random_frame ? "; in a random frame" : "",
        options.output);
}

}  // namespace

void add_survey(CLI::App& program) {
    auto options = std::make_shared<SurveySimulationOptions>();
    CLI::App& command = add_command(
        program, "survey", "Simulate a survey of a form, for trials and teaching",
        "  taut form net.json --law uniform:5mm --seed 7 -o built.csv\n"
        "  taut survey net.json built.csv --noise 0.5mm --drop 10% --shuffle --frame random "
        "-o survey.csv",
        *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("FORM", options->form, "Form to survey: id,x,y,z in m")->required();
    command.add_option("--noise", options->noise,
                       "Standard deviation of normal noise on every coordinate (default: 0)");
    command.add_option("--drop", options->drop, "Part of the free nodes that stays hidden")
        ->capture_default_str();
    command.add_flag("--shuffle", options->simulation.shuffled,
                     "Targets on free nodes without names, in any order");
    command
        .add_option("--frame", options->frame,
                    "net (the net's), or random (an instrument's own, far away)")
        ->check(CLI::IsMember({"net", "random"}))
        ->capture_default_str();
    add_seed_option(command, options->simulation.seed);
    add_output_option(command, options->output, "Survey to write (CSV)");
    command.callback([options] { run(*options); });
}

}  // namespace taut::app
