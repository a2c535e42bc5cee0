// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <set>
#include <string>

#include "files/message.hpp"
#include "results/document_parts.hpp"
#include "results/result_checks.hpp"
#include "results/result_readers.hpp"
#include "results/result_values.hpp"
#include "taut/results/plan_files.hpp"

namespace taut {
namespace {

PlanResult::Tension read_tension(const JsonValue& value, const CableNet& net, int edge) {
    const auto tension = read<PlanResult::Tension>(value);
    if (tension.edge != edge) {
        member(value, "edge")
            .fail(fmt::format("is {}, expected {}: all edges in their order", tension.edge, edge));
    }
    require_tensions(value, {"as_built", "planned", "lower", "upper", "limit_lower", "limit_upper"},
                     net, edge);
    if (!tension.limit_lower && !net.is_strut(edge)) {
        member(value, "limit_lower").fail("is null, expected a number: the edge is a cable");
    }
    if (tension.lower.has_value() != tension.upper.has_value()) {
        value.fail("has one end of the interval of tension, expected both or none");
    }
    if (tension.lower && *tension.lower > *tension.upper) {
        value.fail(
            fmt::format("has the interval of tension from {} to {}, expected lower before "
                        "upper",
                        *tension.lower, *tension.upper));
    }
    if (tension.limit_upper && tension.limit_lower && *tension.limit_lower > *tension.limit_upper) {
        value.fail(fmt::format("has limits of tension from {} to {}, expected lower before upper",
                               *tension.limit_lower, *tension.limit_upper));
    }
    return tension;
}

/// @return its edge
int read_turn(const JsonValue& turn, const CableNet& net) {
    const int edge = read_edge_index(member(turn, "edge"), net);
    if (net.interior_index(edge) >= 0) {
        member(turn, "edge").fail(fmt::format("is {}, expected an adjustable edge", edge));
    }
    require_tensions(turn, {"tension_after_step", "tension_after"}, net, edge);
    const double stroke = member(turn, "stroke").number();
    const std::string expected(action_of(stroke));
    const JsonValue action = member(turn, "action");
    if (action.text() != expected) {
        action.fail(fmt::format("is {}, expected {}: the stroke is {}", quote(action.text()),
                                quote(expected), stroke));
    }
    return edge;
}

}  // namespace

PlanResult read_plan(const JsonValue& root) {
    PlanResult plan{.net = require_net(root)};
    check_names(root, plan.net);
    plan.built_form = require_form(root, "built_form", plan.net);
    plan.planned_form = require_form(root, "planned_form", plan.net);
    check_supports(member(root, "planned_form"), plan.planned_form, plan.net, plan.built_form,
                   "/built_form");
    static_cast<void>(require_form(root, "planned_form_std", plan.net));
    check_covariances(root, "planned_form_covariance", plan.net);
    plan.target_form = require_form(root, "target_form", plan.net);
    plan.target_normals = require_form(root, "target_normals", plan.net);
    const int count = plan.net.edge_count();
    const JsonValue tension = member(root, "tension");
    require_at_most(tension, "least", "most");
    require_at_most(tension, "least_as_built", "most_as_built");
    require_tensions(tension, {"least", "most", "least_as_built", "most_as_built"}, plan.net);
    const JsonValue edges = member(tension, "edges");
    edges.require_array(count, fmt::format("one for each edge: {}", count));
    for (int e = 0; e < count; ++e) {
        plan.tensions.push_back(read_tension(edges.at(e), plan.net, e));
    }
    if (const auto targets = root.find("target_tensions")) {
        int last = -1;
        for (size_t i = 0; i < targets->json().size(); ++i) {
            const JsonValue edge = member(targets->at(i), "edge");
            if (read_edge_index(edge, plan.net) <= last) {
                edge.fail(fmt::format("is {}, expected above {}: ascending", edge.integer(), last));
            }
            last = edge.integer();
        }
    }
    for (const JsonValue& stage : entries(root, "stages")) {
        require_tensions(stage, {"least_tension", "most_tension"}, plan.net);
    }
    std::set<int> turned;
    for (const JsonValue& turn : entries(root, "turns")) {
        turned.insert(read_turn(turn, plan.net));
    }
    const JsonValue feasible = member(root, "feasible");
    if (feasible.json() == true && !entries(root, "violations").empty()) {
        feasible.fail("is true, expected false: /violations has limits that are not kept");
    }
    require_equal(root, "touched", static_cast<int>(turned.size()), "the edges among /turns");
    return plan;
}

}  // namespace taut
