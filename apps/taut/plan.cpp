// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "force_input.hpp"
#include "plan_options.hpp"
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

void print_deviation(const char* what, const FormDeviation& d) {
    say("{:<24}{:>9.2f}{:>9.2f}{:>15.2f}{:>9.2f}{:>9.2f}\n", what, 1e3 * d.mean, 1e3 * d.max,
        1e3 * d.normal_mean, 1e3 * d.normal_max, 1e3 * d.normal_rmse);
}

void print_deviations(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    say("{:<24}{:>18}{:>33}\n", "deviation from target", "3D", "along the normal");
    say("{:<24}{:>9}{:>9}{:>15}{:>9}{:>9}\n", "[mm]", "mean", "max", "mean", "max", "RMS");
    print_deviation("as built", plan.as_built);
    print_deviation("planned", plan.planned);
    print_deviation("unconstrained optimum", plan.unconstrained);
    if (plan.draws > 0) {
        say("standard deviation of the planned form along the normal: {:.2f} mm RMS\n",
            1e3 * plan.normal_std);
    }
    if (!plan.strokes.empty() && plan.draws > 0 && !record.turns->options.tolerance &&
        plan.target_tensions.empty() && plan.gain() < plan.normal_std) {
        say("  The turns gain less than that. Turn fewer edges, or none: --tolerance.\n");
    }
}

/// "edges 3, 17, 21 and 4 more".
std::string edges_text(const CableNet& net, const std::vector<int>& edges) {
    constexpr size_t shown = 5;
    std::string text = edges.size() == 1 ? "edge " : "edges ";
    for (size_t i = 0; i < std::min(shown, edges.size()); ++i) {
        text += (i > 0 ? ", " : "") + net.edge_id(edges[i]);
    }
    return edges.size() > shown ? text + fmt::format(" and {} more", edges.size() - shown) : text;
}

/// Why target tensions are missed, and where they are not known well enough.
void print_obstacles(const PlanRecord& record, const std::vector<ReachedTension>& targets) {
    const auto say_of = [&](const auto& is_meant, std::string_view what) {
        std::vector<int> edges;
        for (const ReachedTension& one : targets) {
            if (is_meant(one)) {
                edges.push_back(one.edge);
            }
        }
        if (!edges.empty()) {
            say("  {} {}: {}\n", edges_text(*record.net, edges),
                edges.size() == 1 ? "is missed" : "are missed", what);
        }
    };
    const auto has = [](TensionObstacle obstacle) {
        return [obstacle](const ReachedTension& one) { return one.obstacle == obstacle; };
    };
    say_of(has(TensionObstacle::turnbuckles),
           "no strokes of these turnbuckles were found that reach all targets, not even unlimited "
           "ones with any form (--suggest-adjustable)");
    say_of(has(TensionObstacle::form),
           "the target form is in the way; a wider --form-tolerance gives the tensions more "
           "weight");
    say_of(has(TensionObstacle::limits),
           "limits of strokes or forces, whole steps or --tolerance are in the way");
}

/// The target tensions, the worst first.
void print_tensions(const PlanRecord& record) {
    constexpr size_t shown = 10;
    std::vector<ReachedTension> targets = record.turns->plan.target_tensions;
    if (targets.empty()) {
        return;
    }
    const bool has_draws = record.turns->plan.draws > 0;
    std::ranges::stable_sort(targets, std::ranges::greater(),
                             [](const ReachedTension& one) { return std::abs(one.deviation()); });
    say("{:<24}{:>16}{:>10}{:>9}{:>15}{:>22}\n", "tension [kN]", "target", "as built", "planned",
        "unconstrained", has_draws ? "mean and std   within" : "");
    for (size_t i = 0; i < std::min(shown, targets.size()); ++i) {
        const ReachedTension& one = targets[i];
        say("{:<24}{:>8.2f} +- {:<4.2f}{:>10.2f}{:>9.2f}{:>15.2f}{}\n",
            "edge " + record.net->edge_id(one.edge), 1e-3 * one.target, 1e-3 * one.tolerance,
            1e-3 * one.as_built, 1e-3 * one.planned, 1e-3 * one.unconstrained,
            has_draws ? fmt::format("{:>8.2f} +- {:<4.2f}{:>5.0f} %", 1e-3 * *one.mean,
                                    1e-3 * *one.std, 100.0 * *one.probability)
                      : "");
    }
    if (targets.size() > shown) {
        say("  and {} more, nearer to their targets\n", targets.size() - shown);
    }
    const auto within =
        std::ranges::count(targets, TensionObstacle::none, &ReachedTension::obstacle);
    say("{} of {} target tensions are within their tolerance{}\n", within, targets.size(),
        has_draws ? ", in the mean of the samples" : ", by the estimate");
    print_obstacles(record, targets);
    const auto unknown = std::ranges::count_if(
        targets, [](const ReachedTension& one) { return one.std && *one.std >= one.tolerance; });
    if (unknown > 0) {
        say("  The survey shows {} of them no better than their tolerance. Measure forces: "
            "identify --forces.\n",
            unknown);
    }
    const auto nodes = record.net->free_nodes();
    const bool is_form_weighed = record.target->normal_weights()(nodes).maxCoeff() > 0.0 ||
                                 record.target->tangential_weights()(nodes).maxCoeff() > 0.0;
    say("  weighed: {}\n", is_form_weighed
                               ? format_length(record.turns->options.weighing_tolerance()) +
                                     " of form counts as much as one tolerance of tension"
                               : "the form does not count, all its weights are 0");
}

/// Targets that would improve the plan if they were surveyed before anything is turned.
void print_suggested_targets(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    if (!record.turns->options.survey_noise) {
        return;
    }
    const std::string noise = format_length(*record.turns->options.survey_noise);
    if (plan.draws == 0) {
        say("no targets are suggested, since {}\n", plan.no_draws_because);
        return;
    }
    if (plan.suggested_targets.empty()) {
        say("no single further target, surveyed to {}, would improve the planned form\n", noise);
        return;
    }
    say("suggested targets, surveyed to {}: they reduce these {:.2f} mm to\n", noise,
        1e3 * plan.normal_std);
    for (const SuggestedTarget& target : plan.suggested_targets) {
        say("  {:<12} {:.3f} mm, together with those above\n", record.net->node_id(target.node),
            1e3 * target.normal_std);
    }
    say("  the planned turns reduce the normal RMS by {:.2f} mm\n", 1e3 * plan.gain());
}

void print_strokes(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const PlanOptions& options = record.turns->options;
    if (options.turn && options.turn->step() > 0.0) {
        say("normal RMS in whole steps of {}: {:.3f} mm, without steps {:.3f} mm\n",
            format_length(options.turn->step()), 1e3 * plan.planned.normal_rmse,
            1e3 * plan.normal_rmse_of_free_strokes);
    }
    say("turn {} of {} edges, by at most {:.2f} mm\n", plan.strokes.size(), options.edges.size(),
        1e3 * plan.largest_stroke());
    if (options.tolerance) {
        say("within {}: {}{}\n", format_length(*options.tolerance),
            *plan.is_within_tolerance ? "yes" : "no",
            plan.fewest_bound
                ? fmt::format("; to first order at least {} edges are needed", *plan.fewest_bound)
                : "");
    }
    say("tension: {:.3g} to {:.3g} kN as planned\n", 1e-3 * plan.tensions.minCoeff(),
        1e-3 * plan.tensions.maxCoeff());
}

std::string where_text(const CableNet& net, const LimitBreach& breach) {
    const auto in_kn = [](double force, int digits) {
        return fmt::format("{:.{}g}", 1e-3 * force, digits);
    };
    // As many digits as show the force and its limit to differ.
    constexpr int most_digits = 6;
    int digits = 3;
    while (digits < most_digits && in_kn(breach.value, digits) == in_kn(breach.limit, digits)) {
        ++digits;
    }
    return fmt::format("{}{}: {} kN, limit {} kN",
                       breach.kind == LimitBreach::Kind::tension
                           ? "edge " + net.edge_id(breach.index)
                           : "support " + net.node_id(breach.index),
                       breach.load_case.empty() ? "" : " under " + breach.load_case,
                       in_kn(breach.value, digits), in_kn(breach.limit, digits));
}

std::string kept_text(const LimitBreach& breach) {
    return fmt::format(", kept with a probability of {:.0f} %", 100.0 * breach.probability);
}

void print_limits(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const bool is_limited = record.turns->limits.has_forces(record.built->net);
    if (!is_limited) {
        say("no limits of tension or reaction were given\n");
    }
    if (plan.draws > 0) {
        say("{} with a probability of {:.1f} % (required: {:g} %, at least {} of {} samples)\n",
            is_limited ? "All limits are kept" : "All cables stay taut",
            100.0 * *plan.limit_probability, 100.0 * record.turns->options.confidence,
            plan.draws_needed, plan.draws);
        if (!plan.is_feasible && std::round(*plan.limit_probability * plan.draws) >=
                                     static_cast<double>(plan.draws_needed)) {
            say("  but the estimate itself breaks limits: do not rely on this probability\n");
        }
    } else {
        const std::string_view kept = is_limited ? "limits are kept" : "no cable goes slack";
        const std::string_view broken = is_limited ? "limits are broken" : "cables go slack";
        say("{} by the estimate{}\n", plan.is_feasible ? kept : broken,
            is_limited ? "" : "; its probability is not known, since " + plan.no_draws_because);
    }
    constexpr size_t shown = 10;
    for (size_t i = 0; i < std::min(shown, plan.breaches.size()); ++i) {
        say("  {}{}\n", where_text(*record.net, plan.breaches[i]),
            plan.draws > 0 ? kept_text(plan.breaches[i]) : "");
    }
    if (plan.breaches.size() > shown) {
        say("  and {} more\n", plan.breaches.size() - shown);
    }
}

void print_order(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const TurnOrder& order = record.turns->order;
    const int crews = record.turns->crews;
    say("Order of work: {} pass{}, {} crew{}, {:.0f} m of walking. {}\n", order.passes,
        order.passes == 1 ? "" : "es", crews, crews == 1 ? "" : "s", order.walk,
        order.is_safe ? "No step breaks a limit that was kept before."
                      : "No order was found in which no step breaks a limit.");
    if (plan.draws > 0 && !plan.strokes.empty()) {
        say("  probability that no step breaks a limit: {:.1f} % (required: {:g} %)\n",
            100.0 * order.safe_probability, 100.0 * record.turns->options.confidence);
    }
    int first = 1;
    for (const StageEnd& stage : order.stages) {
        if (stage.step + 1 < first) {
            say("  stage {}: nothing to turn\n", stage.name);
            continue;
        }
        say("  stage {}, to {:g} % of its strokes: steps {} to {}, then {:.3g} to {:.3g} kN{}\n",
            stage.name, 100.0 * stage.part, first, stage.step + 1, 1e-3 * stage.least_tension,
            1e-3 * stage.most_tension,
            plan.draws > 0
                ? fmt::format("; probability that no step until then breaks a limit: {:.1f} %",
                              100.0 * stage.safe_probability)
                : "");
        first = stage.step + 2;
    }
    if (!order.is_safe && order.worst.step >= 0) {
        say("  at step {} {}{}\n", order.worst.step + 1,
            where_text(*record.net, order.worst.breach),
            order.worst.breach.probability > 0.0 ? kept_text(order.worst.breach) : "");
    }
}

void print_suggested_edges(const PlanRecord& record) {
    const auto& suggested = record.turns->suggested_adjustable;
    if (!suggested) {
        return;
    }
    say("{}\n", suggested->empty()
                    ? "no further adjustable edge would help"
                    : "suggested further adjustable edges, each with those above it:");
    for (const SuggestedEdge& one : *suggested) {
        say("  edge {}: by {:.2f} mm, which leaves a normal RMS of {:.3f} mm{}\n",
            record.net->edge_id(one.edge), 1e3 * one.stroke, 1e3 * one.normal_rmse_after,
            one.tension_rmse_after
                ? fmt::format(" and tensions {:.2f} tolerances off", *one.tension_rmse_after)
                : "");
    }
}

void print(const PlanCommand& command, const PlanRecord& record) {
    for (const std::string& warning : plan_warnings(record)) {
        say("{}\n", warning);
    }
    if (!record.trust->findings.empty() &&
        record.trust->verdict() != Trust::Verdict::failed) {  // then the first warning says so
        say("identification {}: {}\n", to_string(record.trust->verdict()),
            record.trust->findings.front().reason);
    }
    print_deviations(record);
    print_tensions(record);
    print_suggested_targets(record);
    print_strokes(record);
    print_limits(record);
    print_order(record);
    print_suggested_edges(record);
    say("written to {}\n", command.output);
    if (!command.csv.empty()) {
        say("written to {}: the list for the crews{}\n", command.csv,
            record.turns->plan.is_feasible ? "" : ", which breaks limits");
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
        print(command, record);
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
