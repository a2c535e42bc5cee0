// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "dicts.hpp"
#include "documents.hpp"
#include "given.hpp"
#include "identified.hpp"
#include "planned.hpp"
#include "states.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/suggested_edges.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/files/file.hpp"
#include "taut/results/plan_files.hpp"

namespace taut::python {
namespace {

/// What plan_to_json(), plan_to_csv() or plan_warnings() make of a plan.
template <class Write>
auto written(const Planned& planned, Write write) {
    const FormTarget target(planned.net, planned.target);
    return write(PlanRecord{.net = &planned.net,
                            .built = &planned.built,
                            .trust = &planned.trust,
                            .target = &target,
                            .limits = &planned.limits,
                            .options = &planned.options,
                            .plan = &planned.plan,
                            .order = &planned.order,
                            .further = planned.suggested_adjustable,
                            .crews = planned.crews,
                            .thread = planned.thread});
}

std::string plan_json(const Planned& planned) {
    return written(planned, [](const PlanRecord& record) { return plan_to_json(record); });
}

std::string plan_csv(const Planned& planned) {
    return written(planned, &plan_to_csv);
}

using Range = std::pair<std::optional<double>, std::optional<double>>;

TensionLimits tension_limits(const CableNet& net, const std::optional<Range>& range) {
    TensionLimits limits = TensionLimits::no_slack(net);
    if (range && range->first) {
        limits.lower.setConstant(*range->first);
    }
    if (range && range->second) {
        limits.upper.setConstant(*range->second);
    }
    return limits;
}

Plan plan_on(const BuiltNet& built, const FormTarget& target, const Limits& limits,
             const PlanOptions& options, const Progress& progress) {
    try {
        return plan_strokes(built, target, limits, options, progress);
    } catch (const FailedIdentification& failed) {
        throw std::invalid_argument(fmt::format(
            "identification: {}; accept_failed=True plans on it all the same, for study only",
            failed.what()));
    }
}

Planned planned(const Identified& identified, const std::optional<ArrayLike>& target, double stroke,
                const std::optional<Range>& tension, const std::optional<ArrayLike>& edges,
                const std::optional<double>& turn, const std::optional<double>& step,
                const std::optional<double>& tolerance, double confidence, double actuator_std,
                int crews, const std::optional<std::string>& thread, int suggest_adjustable,
                const std::optional<double>& suggest_targets, bool accept_failed,
                const nb::object& progress) {
    const CableNet& net = identified.net;
    PlanOptions options{.edges = edges ? indices_argument(*edges, "edges") : net.adjustable_edges(),
                        .confidence = confidence,
                        .actuator_std = actuator_std,
                        .tolerance = tolerance,
                        .survey_noise = suggest_targets,
                        .accept_failed = accept_failed};
    if (edges && options.edges.empty()) {
        throw nb::value_error("edges: got none, expected those that may be turned");
    }
    std::ranges::sort(options.edges);
    if (turn) {
        options.turn = TurnSize{.pitch = *turn, .smallest = step.value_or(0.0)};
    } else if (step) {
        throw nb::value_error("step: is a part of a turn, and turn is not given");
    }
    Limits limits = limits_of_stroke(net, options.edges.size(), stroke);
    limits.tension = tension_limits(net, tension);
    const FormTarget form(
        net, target ? points_argument(*target, "target", net.node_count()) : net.nodes());
    const std::optional<Thread> threads =
        thread ? std::optional(thread_named(*thread)) : std::nullopt;
    if (suggest_adjustable < 0) {
        throw nb::value_error(
            fmt::format("suggest_adjustable: got {}, expected 0 or more", suggest_adjustable)
                .c_str());
    }
    return interruptible(progress, [&](const Progress& reporter) {
        BuiltNet built = built_net_of(net, identified.found);
        Plan plan = plan_on(built, form, limits, options, reporter);
        TurnOrder order = order_turns(built, limits, plan,
                                      {.crews = crews,
                                       .turn_step = options.turn ? options.turn->step() : 0.0,
                                       .confidence = options.confidence,
                                       .actuator_std = options.actuator_std,
                                       .seed = options.seed},
                                      reporter);
        std::optional<std::vector<SuggestedEdge>> suggested;
        if (suggest_adjustable > 0) {
            suggested =
                suggested_edges(built, form, limits, options, plan, suggest_adjustable, reporter);
        }
        return Planned{.net = net,
                       .built = std::move(built),
                       .trust = identified.found.trust,
                       .target = form.places(),
                       .limits = limits,
                       .options = options,
                       .plan = std::move(plan),
                       .order = std::move(order),
                       .suggested_adjustable = std::move(suggested),
                       .crews = crews,
                       .thread = threads};
    });
}

void bind_plan(nb::module_& module) {
    nb::class_<Planned> result(
        module, "Plan",
        "Which turnbuckle to turn how far, in which order, and the form and tensions that follow.");
    make_picklable(result);
    bind_fields<Plan>(
        result, &Planned::plan,
        {{"as_built",
          "Deviation from the target before anything is turned [m]: mean, max and rmse in 3D, "
          "normal_mean, normal_max and normal_rmse along the normal of the target."},
         {"planned", "The same after all strokes [m]."},
         {"unconstrained", "The same after strokes without limits, no edge slack [m]."},
         {"normal_std",
          "Standard deviation of the planned form along the normal, root mean square over the "
          "nodes; 0 without posterior samples [m]."},
         {"suggested_targets",
          "Targets whose survey would tell most of the planned form, the best first, at most ten; "
          "empty without suggest_targets. Of each: node, and normal_std after a survey of this and "
          "those before it [m]."},
         {"form_std",
          "Standard deviations of the planned form (n, 3); 0 without posterior samples [m]."},
         {"tension_lower",
          "Lower ends of the 95 % intervals of the planned tensions (m,); empty without posterior "
          "samples [N]."},
         {"tension_upper", "Upper ends of the same (m,) [N]."},
         {"effective_limits",
          "The limits given less the margin for uncertainty [N]: of the net's loads, then of each "
          "load case, lower and upper of each force, reactions behind tensions."},
         {"draws", "Number of posterior samples in which limits were kept; 0: the estimate alone."},
         {"no_draws_because", "Why there are no posterior samples; else empty."},
         {"limit_probability",
          "Probability that all limits are kept; None without posterior samples."},
         {"is_feasible", "Whether all limits are kept, with the confidence required."},
         {"has_converged", "Whether the search for strokes converged."},
         {"breaches",
          "Limits that are broken, or not surely kept, the worst first. Of each: kind ('tension' "
          "of an edge, 'reaction' of a support), index, load_case, value and limit [N], "
          "probability that it is kept."},
         {"normal_rmse_of_free_strokes",
          "normal_rmse that strokes would leave that are no whole steps [m]."},
         {"is_within_tolerance", "Whether the tolerance is reached; None without."},
         {"fewest_bound",
          "Number of edges below which, to first order, the tolerance cannot be reached; None "
          "without."},
         {"iterations", "Steps of the search for strokes."}});
    result
        .def_prop_ro(
            "edges", [](const Planned& self) { return edges_of_each(self.plan.strokes); },
            "Edges that are turned, ascending (k,).")
        .def_prop_ro(
            "strokes",
            [](const Planned& self) {
                return array_of_each(self.plan.strokes, &PlannedStroke::stroke);
            },
            "Change of the unstressed length of each (k,), positive lengthens [m].")
        .def_prop_ro(
            "form",
            [](nb::handle_t<Planned> self) {
                return view_of(nb::cast<const Planned&>(self).plan.form, self);
            },
            "Planned form (n, 3) [m].")
        .def_prop_ro(
            "tension",
            [](nb::handle_t<Planned> self) {
                return view_of(nb::cast<const Planned&>(self).plan.tensions, self);
            },
            "Planned tensions (m,) [N].")
        .def_prop_ro(
            "order", [](const Planned& self) { return in_python_types(self.order); },
            "Order of the work: turns, of each its edge, stroke [m], pass, crew and step (turns of "
            "one step are made at once); passes; walk of all crews [m]; safe_probability and "
            "is_safe; worst, the step (-1: none) with the worst breach of a limit.")
        .def_prop_ro(
            "suggested_adjustable",
            [](const Planned& self) { return in_python_types(self.suggested_adjustable); },
            "Edges that would help most if they were made adjustable, each with those before it: "
            "edge, stroke and normal_rmse_after [m]; None without suggest_adjustable.")
        .def_prop_ro(
            "is_safe", [](const Planned& self) { return self.order.is_safe; },
            "Whether no step of the work breaks a limit that was kept before, with the confidence "
            "required.")
        .def_prop_ro(
            "safe_probability", [](const Planned& self) { return self.order.safe_probability; },
            "Probability that no step of the work breaks a limit that was kept before; 0 or 1 "
            "without posterior samples.")
        .def_prop_ro(
            "warnings", [](const Planned& self) { return written(self, &plan_warnings); },
            "Why the plan must not be carried out, the worst first: the first lines of its lists.")
        .def_ro("net", &Planned::net, "As designed.")
        .def_prop_ro(
            "trust", [](const Planned& self) { return to_string(self.trust.verdict()); },
            "Of the identification: 'passed', 'doubtful' or 'failed'.")
        .def(
            "to_dataframe",
            [](nb::handle_t<Planned> self) {
                return of_package("taut.tables", "plan_frame")(self);
            },
            nb::sig("def to_dataframe(self) -> object"),
            "The edges that are turned as a pandas.DataFrame, SI units.")
        .def("_repr_html_",
             [](nb::handle_t<Planned> self) {
                 return of_package("taut.notebook", "result_html")(self);
             })
        .def("to_csv", &plan_csv, "The list for the crews, as CSV.")
        .def("to_json", &plan_json, "What plan.json holds.")
        .def(
            "to_dict", [](const Planned& self) { return dict_of(plan_json(self)); },
            "What plan.json holds, as a dict.")
        .def(
            "save",
            [](const Planned& self, const std::filesystem::path& path,
               const std::optional<std::filesystem::path>& csv) {
                std::vector<std::pair<std::filesystem::path, std::string>> files;
                if (csv) {
                    files.emplace_back(*csv, plan_csv(self));
                }
                files.emplace_back(path, plan_json(self));
                write_files(files);
            },
            nb::arg("path"), nb::arg("csv") = nb::none(),
            "Writes plan.json, and to csv the list for the crews.")
        .def("__repr__", [](const Planned& self) {
            return fmt::format(
                "Plan({} of {} edges, by at most {:.2f} mm; {}; along the normal {:.2f} mm RMS, "
                "{:.2f} mm as built{})",
                self.plan.strokes.size(), self.options.edges.size(),
                1e3 * self.plan.largest_stroke(),
                self.plan.is_feasible ? "limits are kept" : "LIMITS ARE BROKEN",
                1e3 * self.plan.planned.normal_rmse, 1e3 * self.plan.as_built.normal_rmse,
                self.trust.verdict() == Trust::Verdict::passed
                    ? ""
                    : fmt::format("; the identification is {}", to_string(self.trust.verdict())));
        });
}

}  // namespace

void bind_adjustment(nb::module_& module) {
    bind_plan(module);
    module.def("plan", &planned, nb::arg("identification"), nb::arg("target") = nb::none(),
               nb::kw_only(), nb::arg("stroke") = 0.02, nb::arg("tension") = nb::none(),
               nb::arg("edges") = nb::none(), nb::arg("turn") = nb::none(),
               nb::arg("step") = nb::none(), nb::arg("tolerance") = nb::none(),
               nb::arg("confidence") = 0.95, nb::arg("actuator_std") = 0.0, nb::arg("crews") = 1,
               nb::arg("thread") = nb::none(), nb::arg("suggest_adjustable") = 0,
               nb::arg("suggest_targets") = nb::none(), nb::arg("accept_failed") = false,
               nb::arg("progress") = nb::none(),
               R"(Strokes that bring the net near a target and keep its limits, and their order.

Args:
    identification: of identify(), with its posterior samples.
    target: form to approach (n, 3), by default the nominal one [m].
    stroke: longest stroke of each edge, either way [m].
    tension: (least, most) of every edge; either may be None [N].
    edges: that may be turned, by default the adjustable ones.
    turn: change of length by one turn [m].
    step: smallest part of a turn that a crew can do, 0.25 say.
    tolerance: turn the fewest edges that bring the normal deviation below this [m].
    confidence: required probability that all limits are kept.
    actuator_std: standard deviation of a stroke from the one planned [m].
    crews: number that work at the same time.
    thread: 'right' or 'left', of all turnbuckles, in place of what the net gives.
    suggest_adjustable: number of edges to suggest that would help if they were adjustable.
    suggest_targets: suggest targets to survey before turning, each measured with this standard
        deviation [m].
    accept_failed: plan on an identification that failed its checks, too; the first line of the
        lists then says that they must not be used.
    progress: called with stage, done, total.)");
}

}  // namespace taut::python
