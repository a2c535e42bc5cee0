// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "tension_target_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "taut/net/units.hpp"
#include "terminal.hpp"

namespace taut::app {
namespace {

/// "edges 3, 17, 21 and 4 more".
std::string first_edges_text(const CableNet& net, const std::vector<int>& edges) {
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
            say("  {} {}: {}\n", first_edges_text(*record.net, edges),
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

}  // namespace

void print_tension_targets(const PlanRecord& record) {
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
                                    1e-3 * *one.std_dev, 100.0 * *one.probability)
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
    const auto unknown = std::ranges::count_if(targets, [](const ReachedTension& one) {
        return one.std_dev && *one.std_dev >= one.tolerance;
    });
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

}  // namespace taut::app
