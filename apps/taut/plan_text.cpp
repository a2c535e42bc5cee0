// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "plan_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "taut/adjustment/plan_turns.hpp"
#include "taut/net/units.hpp"
#include "tension_target_text.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

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

}  // namespace

void print_plan(const PlanRecord& record) {
    for (const std::string& warning : plan_warnings(record)) {
        say("{}\n", warning);
    }
    if (!record.trust->findings.empty() &&
        record.trust->verdict() != Trust::Verdict::failed) {  // then the first warning says so
        say("identification {}: {}\n", to_string(record.trust->verdict()),
            record.trust->findings.front().reason);
    }
    print_deviations(record);
    print_tension_targets(record);
    print_suggested_targets(record);
    print_strokes(record);
    print_limits(record);
    print_order(record);
    print_suggested_edges(record);
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

}  // namespace taut::app
