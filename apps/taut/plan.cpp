// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "command.hpp"
#include "force_input.hpp"
#include "plan_options.hpp"
#include "plan_text.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "taut/results/built_net.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/plan_files.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct PlanCommand : CommonOptions {
    PlanRequest request;  ///< but for what files hold
    std::string net;
    std::string result;
    std::string output;
    std::string csv;
    std::string stroke = "15mm";  ///< or a file
    std::string target;
    double target_unit = 1.0;  ///< [m]
    DeviationWeights weights;
    std::string node_weights;
    std::vector<std::string> target_tensions;  ///< forces, or files
    FormObjective objective = FormObjective::rms;
    std::string adjustable;
    std::vector<std::string> checks;

    [[nodiscard]] std::vector<std::string> inputs() const {
        std::vector<std::string> all = checks;
        all.insert(all.end(), target_tensions.begin(), target_tensions.end());
        all.insert(all.end(), {net, result, draws_path(result).string(), target, node_weights,
                               adjustable, stroke});
        return all;
    }
};

FormTarget target_of(const CableNet& net, const PlanCommand& command) {
    GivenTarget given = read_target(net, command.target, command.target_unit);
    given.weights = command.weights;
    given.objective = command.objective;
    const bool is_surface = !given.triangles.empty();
    FormTarget target =
        is_surface ? naming_file(command.target, [&] { return taut::target_of(net, given); })
                   : taut::target_of(net, given);
    warn(command.target, target_warnings(net, target));
    if (!command.node_weights.empty()) {
        const std::vector<NodeWeights> weights =
            parse_node_weights(net, read_table(command.node_weights), command.node_weights);
        naming_file(command.node_weights, [&] { target.set_weights(weights); });
    }
    return target;
}

/// The request with what its files hold.
PlanRequest request_of(const CableNet& net, const PlanCommand& command) {
    PlanRequest request = command.request;
    if (!command.adjustable.empty()) {
        request.options.edges = read_edge_list(net, command.adjustable);
    }
    if (std::filesystem::is_regular_file(command.stroke)) {
        request.stroke_ranges =
            parse_stroke_ranges(net, read_table(command.stroke), command.stroke);
    } else {
        request.stroke = parse_length(command.stroke);
    }
    for (const std::string& text : command.target_tensions) {
        if (std::filesystem::is_regular_file(text)) {
            const std::vector<GivenTension> of_file =
                parse_target_tensions(net, read_table(text), text);
            request.target_tension.insert(request.target_tension.end(), of_file.begin(),
                                          of_file.end());
        } else {
            request.target_tension.push_back(parse_target_tension(text));
        }
    }
    for (const std::string& file : command.checks) {
        request.load_cases.push_back(
            {.name = file, .loads = parse_loads(net, read_table(file), file)});
    }
    return request;
}

void print_written(const PlanCommand& command, const Plan& plan) {
    say("written to {}\n", command.output);
    if (!command.csv.empty()) {
        say("written to {}: the list for the crews{}\n", command.csv,
            plan.is_feasible ? "" : ", which breaks limits");
    }
}

/// @throws NumericalFailure where the plan breaks limits
void refuse_unless_feasible(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const PlanOptions& options = record.turns->options;
    if (plan.is_feasible) {
        return;
    }
    throw NumericalFailure(fmt::format(
        "no strokes were found that keep all limits{}{}. The written plan comes closest: {}",
        plan.draws > 0 ? fmt::format(" with a probability of {:.0f} %", 100.0 * options.confidence)
                       : "",
        options.turn && options.turn->step() > 0.0 ? ", in whole steps" : "",
        plan.breaches.empty() ? "some posterior samples find no equilibrium"
                              : where_text(*record.net, plan.breaches.front())));
}

PlannedTurns planned(const PlanCommand& command, const CableNet& net, const BuiltNet& built,
                     const FormTarget& target, const PlanRequest& request) {
    ProgressLine line(command.quiet);
    try {
        return plan_turns(net, built, target, request, line.progress());
    } catch (const FailedIdentification& failed) {
        throw InputError(
            command.result, "",
            fmt::format("{}; --accept-failed plans all the same, for study only", failed.what()));
    }
}

void run(const PlanCommand& command) {
    const CableNet net = read_net(command.net).net;
    const IdentifiedNet identified = read_identified_net(net, command.result);
    const FormTarget target = target_of(net, command);
    const PlanRequest request = request_of(net, command);
    check_outputs({command.output, command.csv}, command.inputs());
    const PlannedTurns turns = planned(command, net, identified.built, target, request);
    const PlanRecord record{.net = &net,
                            .built = &identified.built,
                            .trust = &identified.trust,
                            .target = &target,
                            .turns = &turns};
    const std::string document = plan_to_json(record, run_record());
    // The list first: beside a new plan, crews would work off the list of an older one.
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    if (!command.csv.empty()) {
        files.emplace_back(command.csv, plan_to_csv(record));
    }
    files.emplace_back(command.output, document);
    write_files(files);
    if (command.json) {
        say("{}", document);
    } else {
        print_plan(record);
        print_written(command, turns.plan);
    }
    refuse_unless_feasible(record);
}

void add_target_options(CLI::App& command, PlanCommand& options) {
    command
        .add_option("--target", options.target,
                    "Target form, id,x,y,z, or target surface, .obj or .ply (default: the nodes of "
                    "NET)")
        ->group(heading::input);
    add_parsed(
        command, "--target-unit", options.target_unit,
        [](const std::string& unit) { return length_of_unit(unit).value(); },
        "Unit of a surface's coordinates", "m")
        ->check(CLI::IsMember({"m", "mm", "cm", "ft", "us-ft", "in"}))
        ->group(heading::input);
    add_parsed(command, "--weights", options.weights, parse_weights,
               "Weights of squared deviations along the target's normal and across it "
               "(default: normal:1,tangential:0.1)")
        ->group(heading::input);
    command
        .add_option("--node-weights", options.node_weights,
                    "Other weights of single nodes, a file id,normal,tangential")
        ->group(heading::input);
    command
        .add_option("--target-tension", options.target_tensions,
                    "Target tension of all edges or a group, 12kN[:TOLERANCE][@GROUP], TOLERANCE "
                    "5% or 300N (default: 5%); or a file edge,tension[,tolerance] in N. May be "
                    "repeated")
        ->group(heading::input);
    add_parsed(command, "--form-tolerance", options.request.options.form_tolerance, parse_length,
               "Form deviation that counts as much as target tensions off by their tolerances "
               "(default: --tolerance, else 5mm)")
        ->group(heading::input);
    add_parsed(
        command, "--objective", options.objective,
        [](const std::string& name) {
            return name == "rms" ? FormObjective::rms : FormObjective::largest;
        },
        "What is minimised: the RMS of the deviations, or the largest", "rms")
        ->check(CLI::IsMember({"rms", "largest"}))
        ->group(heading::input);
}

void add_limit_options(CLI::App& command, PlanCommand& options) {
    PlanRequest& request = options.request;
    add_parsed(command, "--tolerance", request.options.tolerance, parse_length,
               "Turn the fewest edges with which the RMS along the normal (the max, with "
               "--objective largest) is at most this, and target tensions are within theirs")
        ->group(heading::limits);
    add_parsed(command, "--confidence", request.options.confidence, parse_part,
               "Probability with which all limits hold, over the posterior samples of RESULT",
               "95%")
        ->group(heading::limits);
    add_parsed(command, "--total-stroke", request.total_stroke, parse_length,
               "Largest deviation of a turnbuckle from its designed length in NET, either "
               "way (default: any)")
        ->group(heading::limits);
    add_each_parsed(command, "--reaction", request.reaction, parse_reaction_bound,
                    "Largest force at a support, 20kN[@GROUP of edges]. May be repeated")
        ->group(heading::limits);
    command
        .add_option("--check", options.checks,
                    "Later additional loads, a file id,x,y,z in N, under which the limits of "
                    "tension hold as well. May be repeated")
        ->group(heading::limits);
}

}  // namespace

void add_plan(CLI::App& program) {
    auto options = std::make_shared<PlanCommand>();
    PlanRequest& request = options->request;
    CLI::App& command = add_command(
        program, "plan",
        "Plan which turnbuckles to turn, how far and in which order, to reach the target form "
        "within\nlimits of force",
        "  taut plan net.json result.json -o plan.json --csv turns.csv --tension 1.5kN..10kN \\\n"
        "      --turn 5mm --step 1/4 --thread right\n"
        "  taut plan net.json result.json -o plan.json --target roof.obj --target-unit mm \\\n"
        "      --tolerance 2mm --suggest-adjustable 3",
        *options);
    command.add_option("NET", options->net, "Net file, as designed")->required();
    command.add_option("RESULT", options->result, "Result of taut identify")->required();
    add_output_option(command, options->output, "Plan to write (JSON)");
    command.add_option("--csv", options->csv, "List for the crews to write (CSV)");
    add_each_parsed(command, "--tension", request.tension, parse_tension_range,
                    "Limits of tension, 1.5kN..10kN[@GROUP], or parts of the breaking load in "
                    "NET, 20%..60%. May be repeated (default: no edge slack)");
    command
        .add_option("--stroke", options->stroke,
                    "Largest change of length of a turnbuckle from where it is now, either way; "
                    "or a file edge,shortest,longest in m")
        ->capture_default_str();
    add_turn_options(
        command, request.options.turn,
        "Smallest part of a turn, such as 1/4: strokes are whole steps (default: any)");
    add_parsed(
        command, "--thread", request.thread,
        [](const std::string& name) { return name == "right" ? Thread::right : Thread::left; },
        "Thread of all turnbuckles, overriding that of each in NET. Without either the "
        "plan has no sense of rotation")
        ->check(CLI::IsMember({"right", "left"}));
    command.add_option("--crews", request.crews, "Number of crews that turn at the same time")
        ->capture_default_str();
    add_parsed(
        command, "--stages", request.stages, parse_stages,
        "Groups of edges to turn one after the other, each up to a part of its strokes, such "
        "as ridge:50%,valley,ridge; all else comes last (default: all at once)");
    add_target_options(command, *options);
    command
        .add_option("--adjustable", options->adjustable,
                    "Edges that may be turned, one a line (default: those of NET)")
        ->group(heading::input);
    add_parsed(command, "--actuator", request.options.actuator_std, parse_length, actuator_help,
               "0mm")
        ->group(heading::known);
    add_limit_options(command, *options);
    command
        .add_option("--suggest-adjustable", request.suggest_adjustable,
                    "Suggest so many further edges that would help most if they were adjustable "
                    "or cut to another length")
        ->check(CLI::Range(1, 1000))
        ->group(heading::output);
    add_parsed(command, "--suggest-targets", request.options.survey_noise, parse_length,
               "Suggest targets to survey before turning, those that would improve the "
               "planned form most if surveyed with this standard deviation, such as 0.5mm")
        ->group(heading::output);
    command
        .add_flag("--accept-failed", request.options.accept_failed,
                  "Plan on an identification that failed its checks, for study. All output says "
                  "that it is not to be used")
        ->group(heading::advanced);
    add_seed_option(command, request.options.seed);
    set_action(command, options, run);
}

}  // namespace taut::app
