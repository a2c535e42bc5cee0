// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "command.hpp"
#include "net_summary.hpp"
#include "plan_options.hpp"
#include "plan_target.hpp"
#include "progress_line.hpp"
#include "run_record.hpp"
#include "survey_input.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/suggested_edges.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "taut/results/built_net.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/plan_files.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

struct PlanCommand : CommonOptions {
    TargetOptions target;
    std::string net;
    std::string result;
    std::string output;
    std::string stroke = "15mm";
    std::string total_stroke;
    std::vector<std::string> tension;
    std::vector<std::string> reaction;
    std::vector<std::string> checks;
    std::string turn;
    std::string step;
    std::string tolerance;
    std::string adjustable;
    std::string confidence = "95%";
    std::string suggest_targets;  ///< standard deviation of a target
    std::string actuator = "0mm";
    std::string thread;
    std::string csv;
    int crews = 1;
    int suggest_adjustable = 0;  ///< how many
    bool accept_failed = false;
    std::uint64_t seed = 1;
};

std::vector<int> group_of(const CableNet& net, const std::string& name, const std::string& option) {
    const auto found = net.data().groups.find(name);
    if (found == net.data().groups.end()) {
        throw std::invalid_argument(
            fmt::format("{} names the group '{}', which the net does not have", option, name));
    }
    return found->second;
}

/// "1.5kN..10kN[@GROUP]", "20%..60%[@GROUP]", either end may be left out.
void take_tension(const CableNet& net, const std::string& text, TensionLimits& limits) {
    const size_t at = text.find('@');
    const TensionRange range = parse_tension_range(text.substr(0, at));
    const Eigen::VectorXd& breaking_load = net.data().breaking_load;
    if (range.has_part() && breaking_load.size() == 0) {
        throw std::invalid_argument(
            fmt::format("--tension is '{}', a part of the breaking load, but the net file has no "
                        "breaking_load (in N)",
                        text));
    }
    const auto set = [&](int edge) {
        const double strength = range.has_part() ? breaking_load(edge) : 0.0;
        if (range.least.is_given) {
            limits.lower(edge) = range.least.at(strength);
        }
        if (range.most.is_given) {
            limits.upper(edge) = range.most.at(strength);
        }
    };
    if (at == std::string::npos) {
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            set(edge);
        }
    } else {
        for (const int edge : group_of(net, text.substr(at + 1), "--tension")) {
            set(edge);
        }
    }
}

/// "20kN[@GROUP]": of the supports at the edges of a group.
ReactionLimit reaction_limit(const CableNet& net, const std::string& text) {
    const size_t at = text.find('@');
    ReactionLimit limit{.name = text, .supports = {}, .upper = parse_force(text.substr(0, at))};
    if (at == std::string::npos) {
        limit.supports = net.supports();
        return limit;
    }
    for (const int edge : group_of(net, text.substr(at + 1), "--reaction")) {
        for (const int node : net.edges()[edge]) {
            if (net.free_index(node) < 0) {
                limit.supports.push_back(node);
            }
        }
    }
    std::ranges::sort(limit.supports);
    const auto doubled = std::ranges::unique(limit.supports);
    limit.supports.erase(doubled.begin(), doubled.end());
    if (limit.supports.empty()) {
        throw std::invalid_argument(
            fmt::format("--reaction is '{}', but no edge of that group is at a support", text));
    }
    return limit;
}

/// Narrows the strokes so that no turnbuckle ends further than `text` from its designed length.
void limit_total_stroke(const CableNet& net, const CableNet& built, const std::string& text,
                        const std::vector<int>& edges, Limits& limits) {
    const double total = parse_length(text);
    if (!(total > 0.0) || std::isinf(total)) {
        throw std::invalid_argument(
            fmt::format("--total-stroke is '{}', expected more than 0", text));
    }
    for (size_t k = 0; k < edges.size(); ++k) {
        const int edge = edges[k];
        const double offset = built.unstressed_lengths()(edge) - net.unstressed_lengths()(edge);
        if (std::abs(offset) > total * (1.0 + 1e-9)) {
            throw std::invalid_argument(fmt::format(
                "--total-stroke is '{}', but the turnbuckle of edge '{}' already is {:.2f} mm from "
                "its designed length",
                text, net.edge_id(edge), 1e3 * offset));
        }
        const auto at = static_cast<Eigen::Index>(k);
        limits.shortest_stroke(at) =
            std::max(limits.shortest_stroke(at), std::min(0.0, -total - offset));
        limits.longest_stroke(at) =
            std::min(limits.longest_stroke(at), std::max(0.0, total - offset));
    }
}

/// The edges that may be turned, and how far.
std::pair<std::vector<int>, Limits> limits_of(const CableNet& net, const CableNet& built,
                                              const PlanCommand& command) {
    std::vector<int> edges = net.adjustable_edges();
    if (!command.adjustable.empty()) {
        edges = parse_edge_list(net, read_file(command.adjustable), command.adjustable);
        std::ranges::sort(edges);
    }
    Limits limits;
    if (std::filesystem::is_regular_file(command.stroke)) {
        std::vector<StrokeRange> ranges =
            parse_stroke_ranges(net, read_file(command.stroke), command.stroke);
        std::ranges::sort(ranges, {}, &StrokeRange::edge);
        for (const StrokeRange& range : ranges) {
            if (!std::ranges::binary_search(edges, range.edge) &&
                !std::ranges::binary_search(net.adjustable_edges(), range.edge)) {
                throw InputError(command.stroke, "",
                                 fmt::format("names edge '{}', which is not adjustable",
                                             net.edge_id(range.edge)));
            }
        }
        std::erase_if(ranges, [&](const StrokeRange& range) {
            return !std::ranges::binary_search(edges, range.edge);
        });
        if (ranges.empty()) {
            throw InputError(command.stroke, "", "leaves no edge that may be turned");
        }
        edges.clear();
        limits = limits_of_stroke(net, ranges.size(), 0.0);
        for (size_t k = 0; k < ranges.size(); ++k) {
            edges.push_back(ranges[k].edge);
            limits.shortest_stroke(static_cast<Eigen::Index>(k)) = ranges[k].shortest;
            limits.longest_stroke(static_cast<Eigen::Index>(k)) = ranges[k].longest;
        }
    } else {
        const double stroke = parse_length(command.stroke);
        if (!(stroke > 0.0)) {
            throw std::invalid_argument(
                fmt::format("--stroke is '{}', expected more than 0", command.stroke));
        }
        limits = limits_of_stroke(net, edges.size(), stroke);
    }
    if (!command.total_stroke.empty()) {
        limit_total_stroke(net, built, command.total_stroke, edges, limits);
    }
    // Limits of all edges first, so that those of a group override them.
    for (const bool is_of_group : {false, true}) {
        for (const std::string& text : command.tension) {
            if ((text.find('@') != std::string::npos) == is_of_group) {
                take_tension(net, text, limits.tension);
            }
        }
    }
    for (const std::string& text : command.reaction) {
        limits.reactions.push_back(reaction_limit(net, text));
    }
    for (const std::string& file : command.checks) {
        limits.load_cases.push_back(
            {.name = file,
             .loads = built.loads() + parse_loads(net, read_file(file), file),
             .tension = limits.tension});
    }
    return {std::move(edges), std::move(limits)};
}

PlanOptions options_of(const PlanCommand& command, std::vector<int> edges) {
    PlanOptions options{.edges = std::move(edges),
                        .confidence = parse_part(command.confidence),
                        .actuator_std = parse_length(command.actuator),
                        .turn = parse_turn(command.turn, command.step),
                        .tolerance = {},
                        .survey_noise = {},
                        .seed = command.seed,
                        .accept_failed = command.accept_failed};
    if (!command.tolerance.empty()) {
        options.tolerance = parse_length(command.tolerance);
    }
    if (!command.suggest_targets.empty()) {
        options.survey_noise = parse_length(command.suggest_targets);
    }
    return options;
}

/// Targets that would improve the plan if they were surveyed before anything is turned.
void print_suggested_targets(const CableNet& net, const Plan& plan, double noise) {
    if (plan.draws == 0) {
        say("no targets are suggested, since {}\n", plan.no_draws_because);
        return;
    }
    if (plan.suggested_targets.empty()) {
        say("no single further target, surveyed to {}, would improve the planned form\n",
            format_length(noise));
        return;
    }
    say("suggested targets, surveyed to {}: they reduce these {:.2f} mm to\n", format_length(noise),
        1e3 * plan.normal_std);
    for (const SuggestedTarget& target : plan.suggested_targets) {
        say("  {:<12} {:.3f} mm, together with those above\n", net.node_id(target.node),
            1e3 * target.normal_std);
    }
    say("  the planned turns reduce the normal RMS by {:.2f} mm\n",
        1e3 * (plan.as_built.normal_rmse - plan.planned.normal_rmse));
}

/// Empty where it is not given: by a wrong one crews would turn the wrong way.
std::optional<Thread> thread_of(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    return text == "right" ? Thread::right : Thread::left;
}

void print_deviation(const char* what, const FormDeviation& d) {
    say("{:<24}{:>9.2f}{:>9.2f}{:>15.2f}{:>9.2f}{:>9.2f}\n", what, 1e3 * d.mean, 1e3 * d.max,
        1e3 * d.normal_mean, 1e3 * d.normal_max, 1e3 * d.normal_rmse);
}

std::string where_text(const CableNet& net, const LimitBreach& breach) {
    // As many digits as show the force and its limit to differ.
    const auto both = [&](int digits) {
        return std::pair(fmt::format("{:.{}g}", 1e-3 * breach.value, digits),
                         fmt::format("{:.{}g}", 1e-3 * breach.limit, digits));
    };
    constexpr int most_digits = 6;
    int digits = 3;
    auto [value, limit] = both(digits);
    while (value == limit && digits < most_digits) {
        std::tie(value, limit) = both(++digits);
    }
    return fmt::format("{} {}{}: {} kN, limit {} kN",
                       breach.kind == LimitBreach::Kind::tension ? "edge" : "support",
                       breach.kind == LimitBreach::Kind::tension ? net.edge_id(breach.index)
                                                                 : net.node_id(breach.index),
                       breach.load_case.empty() ? "" : " under " + breach.load_case, value, limit);
}

void print_breaches(const CableNet& net, const Plan& plan) {
    constexpr size_t shown = 10;
    for (size_t i = 0; i < std::min(shown, plan.breaches.size()); ++i) {
        const LimitBreach& breach = plan.breaches[i];
        say("  {}{}\n", where_text(net, breach),
            plan.draws > 0
                ? fmt::format(", kept with a probability of {:.0f} %", 100.0 * breach.probability)
                : "");
    }
    if (plan.breaches.size() > shown) {
        say("  and {} more\n", plan.breaches.size() - shown);
    }
}

void print_limits(const PlanRecord& record) {
    const Plan& plan = *record.plan;
    const bool is_limited = record.limits->has_forces();
    if (!is_limited) {
        say("no limits of tension or reaction were given\n");
    }
    if (plan.draws > 0) {
        const double kept = std::round(*plan.limit_probability * plan.draws);
        const double needed = std::ceil(record.options->confidence * (plan.draws + 1.0));
        say("{} with a probability of {:.1f} % (required: {:g} %, at least {:.0f} of {} samples)\n",
            is_limited ? "All limits are kept" : "All cables stay taut",
            100.0 * *plan.limit_probability, 100.0 * record.options->confidence, needed,
            plan.draws);
        if (!plan.is_feasible && kept >= needed) {
            say("  but the estimate itself breaks limits: do not rely on this probability\n");
        }
    } else {
        const std::string_view kept = is_limited ? "limits are kept" : "no cable goes slack";
        const std::string_view broken = is_limited ? "limits are broken" : "cables go slack";
        say("{} by the estimate{}\n", plan.is_feasible ? kept : broken,
            is_limited ? "" : "; its probability is not known, since " + plan.no_draws_because);
    }
}

void print_order(const PlanRecord& record) {
    const Plan& plan = *record.plan;
    const TurnOrder& order = *record.order;
    say("Order of work: {} pass{}, {} crew{}, {:.0f} m of walking. {}\n", order.passes,
        order.passes == 1 ? "" : "es", record.crews, record.crews == 1 ? "" : "s", order.walk,
        order.is_safe ? "No step breaks a limit that was kept before."
                      : "No order was found in which no step breaks a limit.");
    if (plan.draws > 0 && !plan.strokes.empty()) {
        say("  probability that no step breaks a limit: {:.1f} % (required: {:g} %)\n",
            100.0 * order.safe_probability, 100.0 * record.options->confidence);
    }
    if (!order.is_safe && order.worst.step >= 0) {
        say("  at step {} {}{}\n", order.worst.step + 1,
            where_text(*record.net, order.worst.breach),
            order.worst.breach.probability > 0.0
                ? fmt::format(", kept with a probability of {:.0f} %",
                              100.0 * order.worst.breach.probability)
                : "");
    }
}

void print(const PlanCommand& command, const PlanRecord& record) {
    const CableNet& net = *record.net;
    const Plan& plan = *record.plan;
    for (const std::string& warning : plan_warnings(record)) {
        say("{}\n", warning);
    }
    if (!record.trust->findings.empty() &&
        record.trust->verdict() != Trust::Verdict::failed) {  // then the first warning says so
        say("identification {}: {}\n", to_string(record.trust->verdict()),
            record.trust->findings.front().reason);
    }
    say("{:<24}{:>18}{:>33}\n", "deviation from target", "3D", "along the normal");
    say("{:<24}{:>9}{:>9}{:>15}{:>9}{:>9}\n", "[mm]", "mean", "max", "mean", "max", "RMS");
    print_deviation("as built", plan.as_built);
    print_deviation("planned", plan.planned);
    print_deviation("unconstrained optimum", plan.unconstrained);
    if (plan.draws > 0) {
        say("standard deviation of the planned form along the normal: {:.2f} mm RMS\n",
            1e3 * plan.normal_std);
    }
    if (!plan.strokes.empty() && plan.draws > 0 && !record.options->tolerance &&
        plan.as_built.normal_rmse - plan.planned.normal_rmse < plan.normal_std) {
        say("  The turns gain less than that. Turn fewer edges, or none: --tolerance.\n");
    }
    if (record.options->survey_noise) {
        print_suggested_targets(net, plan, *record.options->survey_noise);
    }
    if (record.options->turn && record.options->turn->step() > 0.0) {
        say("normal RMS in whole steps of {}: {:.3f} mm, without steps {:.3f} mm\n",
            format_length(record.options->turn->step()), 1e3 * plan.planned.normal_rmse,
            1e3 * plan.normal_rmse_of_free_strokes);
    }
    say("turn {} of {} edges, by at most {:.2f} mm\n", plan.strokes.size(),
        record.options->edges.size(), 1e3 * plan.largest_stroke());
    if (record.options->tolerance) {
        say("within {}: {}{}\n", format_length(*record.options->tolerance),
            *plan.is_within_tolerance ? "yes" : "no",
            plan.fewest_bound
                ? fmt::format("; to first order at least {} edges are needed", *plan.fewest_bound)
                : "");
    }
    say("tension: {:.3g} to {:.3g} kN as planned\n", 1e-3 * plan.tensions.minCoeff(),
        1e-3 * plan.tensions.maxCoeff());
    print_limits(record);
    print_breaches(net, plan);
    print_order(record);
    if (record.further) {
        say("{}\n", record.further->empty()
                        ? "no further adjustable edge would help"
                        : "suggested further adjustable edges, each with those above it:");
        for (const SuggestedEdge& further : *record.further) {
            say("  edge {}: by {:.2f} mm, which leaves a normal RMS of {:.3f} mm\n",
                net.edge_id(further.edge), 1e3 * further.stroke, 1e3 * further.normal_rmse_after);
        }
    }
    say("written to {}\n", command.output);
    if (!command.csv.empty()) {
        say("written to {}: the list for the crews{}\n", command.csv,
            plan.is_feasible ? "" : ", which breaks limits");
    }
}

Plan planned(const std::string& result, const BuiltNet& built, const FormTarget& target,
             const Limits& limits, const PlanOptions& options, const Progress& progress) {
    try {
        return plan_strokes(built, target, limits, options, progress);
    } catch (const FailedIdentification& failed) {
        throw InputError(
            result, "",
            fmt::format("{}; --accept-failed plans all the same, for study only", failed.what()));
    }
}

void run(const PlanCommand& command) {
    const CableNet net = read_net(command.net).net;
    const IdentifiedNet identified = read_identified_net(net, command.result);
    const FormTarget target = command.target.read(net);
    auto [edges, limits] = limits_of(net, identified.built.net, command);
    const PlanOptions options = options_of(command, std::move(edges));
    std::vector<std::string> inputs = command.checks;
    inputs.insert(inputs.end(), {command.net, command.result, draws_path(command.result).string(),
                                 command.target.target, command.target.node_weights,
                                 command.adjustable, command.stroke});
    check_outputs({command.output, command.csv}, inputs);
    ProgressLine line(command.quiet);
    const Plan plan =
        planned(command.result, identified.built, target, limits, options, line.progress());
    const TurnOrder order = order_turns(identified.built, limits, plan,
                                        {.crews = command.crews,
                                         .turn_step = options.turn ? options.turn->step() : 0.0,
                                         .confidence = options.confidence,
                                         .actuator_std = options.actuator_std,
                                         .seed = options.seed},
                                        line.progress());
    std::optional<std::vector<SuggestedEdge>> further;
    if (command.suggest_adjustable > 0) {
        further = suggested_edges(identified.built, target, limits, options, plan,
                                  command.suggest_adjustable, line.progress());
    }
    const PlanRecord record{.net = &net,
                            .built = &identified.built,
                            .trust = &identified.trust,
                            .target = &target,
                            .limits = &limits,
                            .options = &options,
                            .plan = &plan,
                            .order = &order,
                            .further = std::move(further),
                            .crews = command.crews,
                            .thread = thread_of(command.thread)};
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
    if (!plan.is_feasible) {
        throw NumericalFailure(fmt::format(
            "no strokes were found that keep all limits{}{}. The written plan comes closest: {}",
            plan.draws > 0
                ? fmt::format(" with a probability of {:.0f} %", 100.0 * options.confidence)
                : "",
            options.turn && options.turn->step() > 0.0 ? ", in whole steps" : "",
            plan.breaches.empty() ? "some posterior samples find no equilibrium"
                                  : where_text(net, plan.breaches.front())));
    }
}

}  // namespace

void add_plan(CLI::App& program) {
    auto options = std::make_shared<PlanCommand>();
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
    command.add_option("--tension", options->tension,
                       "Limits of tension, 1.5kN..10kN[@GROUP], or parts of the breaking load in "
                       "NET, 20%..60%. May be repeated (default: no edge slack)");
    command
        .add_option("--stroke", options->stroke,
                    "Largest change of length of a turnbuckle from where it is now, either way; "
                    "or a file edge,shortest,longest in m")
        ->capture_default_str();
    command.add_option("--turn", options->turn, "Change of length by one turn, such as 5mm");
    command
        .add_option("--step", options->step,
                    "Smallest part of a turn, such as 1/4: strokes are whole steps (default: any)")
        ->needs("--turn");
    command
        .add_option("--thread", options->thread,
                    "Thread of all turnbuckles, overriding that of each in NET. Without either the "
                    "plan has no sense of rotation")
        ->check(CLI::IsMember({"right", "left"}));
    command.add_option("--crews", options->crews, "Number of crews that turn at the same time")
        ->capture_default_str();
    options->target.add_to(command);
    command
        .add_option("--adjustable", options->adjustable,
                    "Edges that may be turned, one a line (default: those of NET)")
        ->group(heading::input);
    command
        .add_option("--actuator", options->actuator,
                    "Standard deviation of a stroke as made from the stroke as planned")
        ->capture_default_str()
        ->group(heading::known);
    command
        .add_option("--tolerance", options->tolerance,
                    "Turn the fewest edges with which the RMS along the normal (the max, with "
                    "--objective largest) is at most this")
        ->group(heading::limits);
    command
        .add_option("--confidence", options->confidence,
                    "Probability with which all limits hold, over the posterior samples of RESULT")
        ->capture_default_str()
        ->group(heading::limits);
    command
        .add_option("--total-stroke", options->total_stroke,
                    "Largest deviation of a turnbuckle from its designed length in NET, either "
                    "way (default: any)")
        ->group(heading::limits);
    command
        .add_option("--reaction", options->reaction,
                    "Largest force at a support, 20kN[@GROUP of edges]. May be repeated")
        ->group(heading::limits);
    command
        .add_option("--check", options->checks,
                    "Later additional loads, a file id,x,y,z in N, under which the limits of "
                    "tension hold as well. May be repeated")
        ->group(heading::limits);
    command
        .add_option("--suggest-adjustable", options->suggest_adjustable,
                    "Suggest so many further edges that would help most if they were adjustable "
                    "or cut to another length")
        ->check(CLI::Range(1, 1000))
        ->group(heading::output);
    command
        .add_option("--suggest-targets", options->suggest_targets,
                    "Suggest targets to survey before turning, those that would improve the "
                    "planned form most if surveyed with this standard deviation, such as 0.5mm")
        ->group(heading::output);
    command
        .add_flag("--accept-failed", options->accept_failed,
                  "Plan on an identification that failed its checks, for study. All output says "
                  "that it is not to be used")
        ->group(heading::advanced);
    add_seed_option(command, options->seed);
    set_action(command, options, run);
}

}  // namespace taut::app
