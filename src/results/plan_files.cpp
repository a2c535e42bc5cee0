// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/plan_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "adjustment/built_net_parts.hpp"
#include "files/csv_field.hpp"
#include "results/document_parts.hpp"
#include "taut/files/printable.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Nothing too where the edge does not have one support, from which a rotation is seen.
std::optional<Thread> thread_of(const PlanRecord& record, int edge) {
    const auto [s, t] = record.net->edges()[edge];
    if (record.net->is_support(s) == record.net->is_support(t)) {
        return std::nullopt;
    }
    const std::vector<int>& adjustable = record.net->adjustable_edges();
    const std::vector<Thread>& threads = record.net->data().thread;
    const auto found = std::ranges::find(adjustable, edge);
    if (record.turns->thread || threads.empty() || found == adjustable.end()) {
        return record.turns->thread;
    }
    return threads[static_cast<size_t>(found - adjustable.begin())];
}

/// Whether the net as it stands keeps the limits, by the estimate: then turns are for the form.
bool keeps_limits(const PlanRecord& record) {
    const Limits& limits = record.turns->limits;
    const CableNet& net = record.built->net;
    if (!limits.reactions.empty() || !limits.load_cases.empty()) {
        return false;
    }
    const Eigen::VectorXd pull = tensions_of(net, net.unstressed_lengths(), net.nodes());
    const auto& [lower, upper] = limits.tension;
    return (lower.size() == 0 || (pull - lower).minCoeff() >= 0.0) &&
           (upper.size() == 0 || (upper - pull).minCoeff() >= 0.0);
}

/// Whether each limit is rather kept than not: then they fail together alone.
bool are_likely(const std::vector<LimitBreach>& breaches) {
    return !breaches.empty() && std::ranges::all_of(breaches, [](const LimitBreach& one) {
        return one.probability > 0.5;
    });
}

/// By how much the form of the designed lengths misses the target along its normal, where that is
/// half of what the plan leaves or more, and the target is the nodes of the net; else 0 [m].
double missed_by_design(const PlanRecord& record) {
    constexpr double least_force = 0.02;  // of the mean tension, out of balance
    constexpr double least = 1e-4;        // [m]
    const CableNet& net = *record.net;
    const Plan& plan = record.turns->plan;
    if (record.target->surface() != nullptr ||
        record.target->places()(Eigen::all, net.free_nodes()) !=
            net.nodes()(Eigen::all, net.free_nodes()) ||
        imbalance_of(net, net.unstressed_lengths(), net.nodes()).share() < least_force) {
        return 0.0;
    }
    const Equilibrium design = solve_equilibrium(net);
    if (!design.balanced()) {
        return 0.0;
    }
    const double missed = deviation_from(*record.target, net, design.form).normal_rmse;
    return missed > std::max({least, plan.normal_std, 0.5 * plan.planned.normal_rmse}) ? missed
                                                                                       : 0.0;
}

}  // namespace

std::string support_id(const CableNet& net, int edge) {
    for (const int node : net.edges()[edge]) {
        if (net.is_support(node)) {
            return net.node_id(node);
        }
    }
    return {};
}

std::vector<ListedTurning> listed_turnings(const PlanRecord& record) {
    std::map<int, double> reading;
    std::vector<ListedTurning> list;
    for (const Turning& turning : record.turns->order.turnings) {
        const auto [it, is_new] = reading.try_emplace(
            turning.edge, turned_from_design(*record.net, *record.built, turning.edge));
        it->second += turning.stroke;
        list.push_back({.turning = turning,
                        .turns = record.turns->options.turn
                                     ? std::optional(std::abs(turning.stroke) /
                                                     record.turns->options.turn->pitch)
                                     : std::nullopt,
                        .rotation = rotation_of(turning.stroke, thread_of(record, turning.edge)),
                        .reading_after = it->second,
                        .tension_after = record.turns->plan.tensions(turning.edge)});
    }
    return list;
}

std::string_view action_of(double stroke) {
    return stroke < 0.0 ? "shorten" : "lengthen";
}

std::optional<std::string_view> rotation_of(double stroke, std::optional<Thread> thread) {
    if (!thread) {
        return std::nullopt;
    }
    return (stroke < 0.0) == (*thread == Thread::right) ? "clockwise" : "counterclockwise";
}

std::vector<std::string> plan_warnings(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const TurnOrder& order = record.turns->order;
    std::vector<std::string> warnings;
    if (const std::string failure = failure_of(*record.trust); !failure.empty()) {
        warnings.push_back(fmt::format(
            "DO NOT TURN BY THIS LIST: the identification failed its checks: {}", failure));
    }
    if (!plan.is_feasible && are_likely(plan.breaches) &&
        plan.limit_probability.value_or(0.0) < record.turns->options.confidence) {
        warnings.push_back(fmt::format(
            "DO NOT TURN BY THIS LIST: all limits together are kept with a probability of {:.1f} % "
            "(required: {:g} %)",
            100.0 * plan.limit_probability.value_or(0.0),
            100.0 * record.turns->options.confidence));
    } else if (!plan.is_feasible) {
        warnings.emplace_back("DO NOT TURN BY THIS LIST: the plan breaks limits");
    } else if (!order.is_safe && order.worst.breach.probability > 0.0) {
        warnings.push_back(fmt::format(
            "NO SAFE ORDER WAS FOUND: the probability that no step breaks a limit is {:.1f} % "
            "(required: {:g} %)",
            100.0 * order.safe_probability, 100.0 * record.turns->options.confidence));
    } else if (!order.is_safe) {
        warnings.push_back(
            fmt::format("NO SAFE ORDER WAS FOUND: step {} breaks a limit", order.worst.step + 1));
    }
    // Other turns are there to keep limits, or for other aims.
    const bool is_for_form_alone =
        !record.turns->options.tolerance && plan.target_tensions.empty() && keeps_limits(record);
    if (plan.is_feasible && !plan.strokes.empty() && is_for_form_alone && plan.draws > 0 &&
        plan.gain() < plan.normal_std) {
        warnings.push_back(
            fmt::format("THE TURNS GAIN LITTLE: {:.2f} mm RMS along the normal, less than the "
                        "{:.2f} mm to which the planned form is known. Turn fewer edges, or none: "
                        "give a tolerance",
                        1e3 * plan.gain(), 1e3 * plan.normal_std));
    }
    if (const double missed = missed_by_design(record); missed > 0.0) {
        warnings.push_back(
            fmt::format("THE TARGET IS NO FORM OF THIS NET: with all lengths as designed the net "
                        "is {:.2f} mm RMS along the normal from it. Check the net's nodes",
                        1e3 * missed));
    }
    if (plan.draws == 0 && !plan.target_tensions.empty()) {
        warnings.push_back(
            fmt::format("TARGET TENSIONS CANNOT BE PROMISED: they are those of the estimate alone, "
                        "because {}",
                        plan.no_draws_because));
    }
    if (plan.draws == 0 && record.turns->limits.has_forces(record.built->net)) {
        warnings.push_back(
            fmt::format("LIMITS CANNOT BE PROMISED: tensions are not reported, because {}",
                        plan.no_draws_because));
    }
    return warnings;
}

std::string plan_to_csv(const PlanRecord& record) {
    std::string text;
    for (const std::string& warning : plan_warnings(record)) {
        text += fmt::format("# {}\n", printable(warning));
    }
    text +=
        "number,crew,pass,step,edge,support,action,rotation,turns,stroke_mm,scale_reading_mm,"
        "tension_after_kN,frequency_after_step_Hz\n";
    int number = 0;
    for (const ListedTurning& listed : listed_turnings(record)) {
        const Turning& turning = listed.turning;
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{:.3f},{:.3f},{},{}\n", ++number, turning.crew,
            turning.pass, turning.step + 1, csv_field(record.net->edge_id(turning.edge)),
            csv_field(support_id(*record.net, turning.edge)), action_of(turning.stroke),
            listed.rotation.value_or(""), listed.turns ? fmt::format("{:.3f}", *listed.turns) : "",
            1e3 * turning.stroke, 1e3 * listed.reading_after,
            record.turns->plan.draws > 0 ? fmt::format("{:.3f}", 1e-3 * listed.tension_after) : "",
            record.turns->plan.draws > 0 && turning.frequency > 0.0
                ? fmt::format("{:.3f}", turning.frequency)
                : "");
    }
    return text;
}

}  // namespace taut
