// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "given.hpp"
#include "identified.hpp"
#include "plan_arguments.hpp"
#include "planned.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/plan_turns.hpp"

namespace taut::python {
namespace {

PlannedTurns plan_on(const CableNet& net, const BuiltNet& built, const FormTarget& target,
                     const PlanRequest& request, const Progress& progress) {
    try {
        return plan_turns(net, built, target, request, progress);
    } catch (const FailedIdentification& failed) {
        throw std::invalid_argument(fmt::format(
            "identification: {}; accept_failed=True plans on it all the same, for study only",
            failed.what()));
    }
}

Planned planned(const Identified& identified, const std::optional<TargetLike>& target,
                const std::optional<StrokeLike>& stroke, const std::optional<RangeLike>& tension,
                const std::optional<ArrayLike>& edges, const std::optional<QuantityLike>& turn,
                const std::optional<double>& step, const std::optional<QuantityLike>& tolerance,
                double confidence, const QuantityLike& actuator_std, int crews,
                const std::optional<std::string>& thread, int suggest_adjustable,
                const std::optional<QuantityLike>& suggest_targets, bool accept_failed,
                const std::optional<QuantityLike>& total_stroke,
                const std::optional<RangeLike>& tension_part,
                const std::optional<ForceLike>& reaction,
                const std::optional<ArraysByName>& load_cases, const std::string& target_unit,
                const std::optional<std::pair<ArrayLike, ArrayLike>>& weights,
                const std::string& objective, const std::optional<TensionLike>& target_tension,
                const std::optional<QuantityLike>& form_tolerance,
                const std::vector<std::pair<std::string, double>>& stages, std::uint64_t seed,
                const nb::object& progress) {
    const CableNet& net = identified.net;
    PlanRequest request{
        .options = {.confidence = confidence,
                    .actuator_std = length_given(actuator_std, "actuator_std"),
                    .tolerance = length_given(tolerance, "tolerance"),
                    .survey_noise = length_given(suggest_targets, "suggest_targets"),
                    .seed = seed,
                    .accept_failed = accept_failed,
                    .form_tolerance = length_given(form_tolerance, "form_tolerance")},
        .total_stroke = length_given(total_stroke, "total_stroke"),
        .crews = crews,
        .suggest_adjustable = suggest_adjustable};
    if (edges) {
        request.options.edges = indices_argument(*edges, "edges");
        if (request.options.edges.empty()) {
            throw nb::value_error("edges: got none, expected those that may be turned");
        }
    }
    for (const auto& [group, part] : stages) {
        request.stages.push_back({.group = group, .part = part});
    }
    if (step == 0.0) {  // which a TurnSize has for none
        throw nb::value_error("step: got 0, expected a part of a turn");
    }
    if (turn) {
        request.options.turn =
            TurnSize{.pitch = length_given(*turn, "turn"), .smallest = step.value_or(0.0)};
    } else if (step) {
        throw nb::value_error("step: is a part of a turn, and turn is not given");
    }
    if (thread) {
        request.thread = thread_named(*thread);
    }
    add_strokes(request, stroke);
    add_target_tensions(request, net, target_tension);
    add_tension(request, tension, "tension", false);
    add_tension(request, tension_part, "tension_part", true);
    add_reactions(request, reaction);
    add_load_cases(request, net, load_cases);
    GivenTarget given = target_argument(net, target, target_unit);
    given.objective = objective_named(objective);
    if (weights) {
        given.node_weights = node_weights(net, weights->first, weights->second);
    }
    const FormTarget form = target_of(net, given);
    for (const std::string& warning : target_warnings(net, form)) {
        warn("target: " + warning);
    }
    return interruptible(progress, [&](const Progress& reporter) {
        BuiltNet built = built_net_of(net, identified.found);
        PlannedTurns turns = plan_on(net, built, form, request, reporter);
        return Planned{.net = net,
                       .built = std::move(built),
                       .trust = identified.found.trust,
                       .target = std::move(given),
                       .turns = std::move(turns)};
    });
}

}  // namespace

void bind_adjustment(nb::module_& module) {
    bind_plan(module);
    module.def("plan", &planned, nb::arg("identification"), nb::arg("target") = nb::none(),
               nb::kw_only(), nb::arg("stroke") = nb::none(), nb::arg("tension") = nb::none(),
               nb::arg("edges") = nb::none(), nb::arg("turn") = nb::none(),
               nb::arg("step") = nb::none(), nb::arg("tolerance") = nb::none(),
               nb::arg("confidence") = 0.95, nb::arg("actuator_std") = 0.0, nb::arg("crews") = 1,
               nb::arg("thread") = nb::none(), nb::arg("suggest_adjustable") = 0,
               nb::arg("suggest_targets") = nb::none(), nb::arg("accept_failed") = false,
               nb::arg("total_stroke") = nb::none(), nb::arg("tension_part") = nb::none(),
               nb::arg("reaction") = nb::none(), nb::arg("load_cases") = nb::none(),
               nb::arg("target_unit") = "m", nb::arg("weights") = nb::none(),
               nb::arg("objective") = "rms", nb::arg("target_tension") = nb::none(),
               nb::arg("form_tolerance") = nb::none(),
               nb::arg("stages") = std::vector<std::pair<std::string, double>>(),
               nb::arg("seed") = PlanOptions().seed, nb::arg("progress") = nb::none(),
               R"(Strokes that bring the net near a target and keep its limits, and their order.

Lengths and forces are numbers in SI units, or text with a unit: 0.015, "15mm".

Args:
    identification: of identify(), with its posterior samples.
    target: form to approach (n, 3), by default the nominal one [m]; or a surface, as its vertices
        (v, 3) and triangles (f, 3) in a tuple; or the name of a file of a form, or of a surface
        (.obj, .ply).
    stroke: longest stroke of each edge from where it is, either way, by default 0.015 [m]; or
        (shortest, longest) by edge, {3: (-0.01, 0.005)}: others are not turned.
    tension: (least, most) of every cable; either may be None [N]. Or a dict of these by group; the
        key None is for every cable, and groups override it. Of a group of struts they may be
        negative.
    edges: that may be turned, by default the adjustable ones.
    turn: change of length by one turn [m].
    step: smallest part of a turn that a crew can do, 0.25 say.
    tolerance: turn the fewest edges that bring the normal deviation below this [m], and target
        tensions within their tolerances.
    confidence: required probability that all limits are kept.
    actuator_std: standard deviation of a stroke from the one planned [m].
    crews: number that work at the same time.
    thread: 'right' or 'left', of all turnbuckles, in place of what the net gives.
    suggest_adjustable: number of edges to suggest that would help if they were adjustable.
    suggest_targets: suggest targets to survey before turning, each measured with this standard
        deviation [m].
    accept_failed: plan on an identification that failed its checks, too; the first line of the
        lists then says that they must not be used.
    total_stroke: largest deviation of an edge to turn from its designed length, either way [m].
    tension_part: as tension, in parts of the net's breaking_load, 0 to 1.
    reaction: largest force at every support [N], or a dict of these by group of edges: of the
        supports at them.
    load_cases: loads (n, 3) that come on top of the net's own later, by name [N]; limits of forces
        hold under each as well.
    target_unit: unit of a surface's coordinates, 'mm' say.
    weights: of the squared deviations along the target's normal and across it, one number of all
        nodes or (n,) each, by default (1, 0.1).
    objective: what is minimised, 'rms' of the deviations or the 'largest'.
    target_tension: of every edge, or (tension, tolerance), by default with a tolerance of 5 % [N].
        Or a dict of these by group of edges or index of an edge; single edges override groups, and
        these the key None, which is for every edge. Or (m,), NaN for edges without target.
    form_tolerance: form deviation that counts as much as target tensions off by their tolerances,
        by default tolerance, else 0.005 [m].
    stages: [(group of edges, part of its strokes)] to turn one after the other, such as
        [("ridge", 0.5), ("valley", 1.0), ("ridge", 1.0)]; all else comes last.
    seed: of the random errors of the strokes.
    progress: called with stage, done, total.)");
}

}  // namespace taut::python
