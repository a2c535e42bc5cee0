// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <cmath>

#include "command.hpp"
#include "net_summary.hpp"
#include "survey_input.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/polar_csv.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/noise_check.hpp"
#include "taut/survey/simulation.hpp"
#include "taut/survey/target_offsets.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct SurveySimulationOptions : CommonOptions {
    std::string net;
    std::string form;
    std::string offset;
    std::string frame = "net";
    std::string output;
    SurveySimulation simulation;
    PolarSimulation polar;  ///< where there are stations
};

/// "1,-2,0.5" as a place [m].
Eigen::Vector3d parse_place(const std::string& text) {
    Eigen::Vector3d place;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int k = 0; k < 3; ++k) {
        const auto [rest, error] = fast_float::from_chars(at, end, place(k));
        const bool is_followed = k < 2 ? rest != end && *rest == ',' : rest == end;
        if (error != std::errc() || !is_followed || !std::isfinite(place(k))) {
            throw std::invalid_argument(fmt::format(
                "--station is '{}', expected a place in m, x,y,z as in 1.5,-2,0.3", text));
        }
        at = rest + (k < 2 ? 1 : 0);
    }
    return place;
}

/// The observations that instruments at the stations would make.
void simulate_observations(const SurveySimulationOptions& options, const CableNet& net,
                           const Points& form) {
    PolarSimulation simulation = options.polar;
    simulation.dropped_part = options.simulation.dropped_part;
    simulation.shuffled = options.simulation.shuffled;
    simulation.seed = options.simulation.seed;
    const PolarSurvey survey = simulate_polar_survey(net, form, simulation);
    write_file(options.output, polar_to_csv(survey));
    const auto targets = survey.observations.size() / survey.stations.size();
    const auto free_points = targets - net.supports().size();
    const double angle = 1e3 * simulation.angle_std / gon;
    const DistancePrecision& distance = simulation.distance;
    if (options.json) {
        say("{}\n", to_text({{"format", "taut-survey-simulation"},
                             {"version", 1},
                             {"net", counts_json(net)},
                             {"surveyed_free_nodes", free_points},
                             {"surveyed_supports", net.supports().size()},
                             {"stations", survey.stations.size()},
                             {"angle", simulation.angle_std},
                             {"distance", distance.std_dev},
                             {"distance_part", distance.part},
                             {"named", !simulation.shuffled},
                             {"seed", simulation.seed},
                             {"output", options.output}}));
        return;
    }
    say("{}\n{} of {} free nodes and {} supports observed from {} station{}{}; angles {:.3g} "
        "mgon, distances {:.3g} mm + {:.3g} ppm\nwritten to {}\n",
        counts_text(net), free_points, net.free_node_count(), net.supports().size(),
        survey.stations.size(), survey.stations.size() == 1 ? "" : "s",
        simulation.shuffled ? ", under arbitrary names and in any order" : "", angle,
        1e3 * distance.std_dev, 1e6 * distance.part, options.output);
}

void run(const SurveySimulationOptions& given) {
    SurveySimulationOptions options = given;
    SurveySimulation& simulation = options.simulation;
    if (!options.offset.empty()) {
        const TargetOffset offset = parse_target_offset(options.offset);
        simulation.offset = offset.offset;
        simulation.offset_std = offset.std_dev;
    }
    simulation.random_frame = options.frame == "random";
    const CableNet net = read_net(options.net).net;
    refuse_absurd_noise(net, simulation.noise_std);
    const std::vector<std::string> warnings = noise_warnings(net, simulation.noise_std);
    const Points form = read_form(net, options.form);
    check_outputs({options.output}, {options.net, options.form});
    if (!options.polar.stations.empty()) {
        simulate_observations(options, net, form);
        return;
    }
    const std::vector<SurveyPoint> points = simulate_survey(net, form, simulation);
    write_file(options.output, survey_to_csv(points));
    warn("--noise", warnings);
    const auto free_points = points.size() - net.supports().size();
    if (options.json) {
        say("{}\n", to_text({{"format", "taut-survey-simulation"},
                             {"version", 1},
                             {"net", counts_json(net)},
                             {"surveyed_free_nodes", free_points},
                             {"surveyed_supports", net.supports().size()},
                             {"noise", simulation.noise_std},
                             {"offset", simulation.offset},
                             {"offset_std", simulation.offset_std},
                             {"named", !simulation.shuffled},
                             {"frame", options.frame},
                             {"seed", simulation.seed},
                             {"warnings", warnings},
                             {"output", options.output}}));
        return;
    }
    say("{}\n{} of {} free nodes surveyed{}, and {} supports with names; standard deviation "
        "{:.4g} mm"
        "{}{}\nwritten to {}\n",
        counts_text(net), free_points, net.free_node_count(),
        simulation.shuffled ? ", without names and in any order" : "", net.supports().size(),
        1e3 * simulation.noise_std,
        options.offset.empty() ? "" : fmt::format(", offset {}", options.offset),
        simulation.random_frame ? "; in a random frame" : "", options.output);
}

}  // namespace

void add_survey(CLI::App& program) {
    auto options = std::make_shared<SurveySimulationOptions>();
    CLI::App& command = add_command(
        program, "survey", "Simulate a survey of a form, for studies and teaching",
        "  taut form net.json --prior uniform:5mm --seed 7 -o built.csv\n"
        "  taut survey net.json built.csv --noise 0.5mm --drop 10% --shuffle --frame random "
        "-o survey.csv\n"
        "  taut survey net.json built.csv --station 2,-3,1.6 --station 2,6,1.6 --angle 0.3mgon "
        "--range 1mm+1.5ppm -o polar.csv",
        *options);
    command.add_option("NET", options->net, "Net file")->required();
    command.add_option("FORM", options->form, "Form to survey: id,x,y,z in m")->required();
    CLI::Option* const noise =
        add_parsed(command, "--noise", options->simulation.noise_std, parse_noise,
                   "Standard deviation of normal noise on every coordinate (default: 0)");
    CLI::Option* const offset = command.add_option(
        "--offset", options->offset,
        "Offset of targets on free nodes along the net's normal (up), and its standard deviation: "
        "\"3mm:0.2mm\" (default: 0)");
    add_parsed(command, "--drop", options->simulation.dropped_part, parse_part,
               "Part of the free nodes that is not surveyed", "0%");
    command.add_flag("--shuffle", options->simulation.shuffled,
                     "Targets on free nodes without names, in any order");
    CLI::Option* const frame =
        command
            .add_option("--frame", options->frame,
                        "Coordinate system: net (that of the net), or random (an instrument's own, "
                        "far away)")
            ->check(CLI::IsMember({"net", "random"}))
            ->capture_default_str();
    CLI::Option* const station =
        add_each_parsed(
            command, "--station", options->polar.stations, parse_place,
            "Place x,y,z [m] of an instrument in the net's coordinate system. Its angles "
            "and distances are then written instead of coordinates. May be repeated")
            ->allow_extra_args(false)
            ->excludes(noise)
            ->excludes(offset)
            ->excludes(frame);
    add_parsed(
        command, "--angle", options->polar.angle_std,
        [](const std::string& text) { return parse_angle_std(text).angle; },
        "Standard deviation of its directions and zenith angles (default: 0.3mgon)")
        ->needs(station);
    add_parsed(command, "--range", options->polar.distance, parse_distance_precision,
               "Standard deviation of its distances (default: 1mm+1.5ppm)")
        ->needs(station);
    add_seed_option(command, options->simulation.seed);
    add_output_option(command, options->output, "Survey to write (CSV)");
    set_action(command, options, run);
}

}  // namespace taut::app
