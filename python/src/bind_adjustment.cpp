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
#include "documents.hpp"
#include "identified.hpp"
#include "planned.hpp"
#include "states.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/files/file.hpp"
#include "taut/results/plan_files.hpp"

namespace taut::python {
namespace {

/// What plan_to_json(), plan_to_csv() or plan_warnings() tell of a plan.
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
                            .further = {},
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
                int crews, const std::optional<std::string>& thread, bool accept_failed,
                const nb::object& progress) {
    const CableNet& net = identified.net;
    PlanOptions options{.edges = edges ? indices_argument(*edges, "edges") : net.adjustable_edges(),
                        .confidence = confidence,
                        .actuator_std = actuator_std,
                        .tolerance = tolerance,
                        .accept_failed = accept_failed};
    if (edges && options.edges.empty()) {
        throw nb::value_error("edges: got none, expected those that may be turned");
    }
    std::ranges::sort(options.edges);
    if (turn) {
        options.turn = TurnSize{.pitch = *turn, .smallest = step.value_or(0.0)};
    } else if (step) {
        throw nb::value_error("step: is a part of a turn, and turn is not told");
    }
    Limits limits = limits_of_stroke(net, options.edges.size(), stroke);
    limits.tension = tension_limits(net, tension);
    const FormTarget form(
        net, target ? points_argument(*target, "target", net.node_count()) : net.nodes());
    std::optional<Thread> threads;
    if (thread) {
        if (*thread != "right" && *thread != "left") {
            throw nb::value_error(
                fmt::format("thread: got '{}', expected 'right' or 'left'", *thread).c_str());
        }
        threads = *thread == "right" ? Thread::right : Thread::left;
    }
    return interruptible(progress, [&](const Progress& told) {
        BuiltNet built = built_net_of(net, identified.found);
        Plan plan = plan_on(built, form, limits, options, told);
        TurnOrder order = order_turns(built, limits, plan,
                                      {.crews = crews,
                                       .turn_step = options.turn ? options.turn->step() : 0.0,
                                       .confidence = options.confidence,
                                       .actuator_std = options.actuator_std,
                                       .seed = options.seed},
                                      told);
        return Planned{.net = net,
                       .built = std::move(built),
                       .trust = identified.found.trust,
                       .target = form.places(),
                       .limits = limits,
                       .options = options,
                       .plan = std::move(plan),
                       .order = std::move(order),
                       .crews = crews,
                       .thread = threads};
    });
}

nb::dict deviation_dict(const FormDeviation& of) {
    nb::dict dict;
    dict["mean"] = of.mean;
    dict["max"] = of.max;
    dict["rmse"] = of.rmse;
    dict["normal_mean"] = of.normal_mean;
    dict["normal_max"] = of.normal_max;
    dict["normal_rmse"] = of.normal_rmse;
    return dict;
}

void bind_plan(nb::module_& module) {
    nb::class_<Planned> result(
        module, "Plan", "Which turnbuckle to turn how far, in which order, and what comes of it.");
    make_picklable(result);
    result
        .def_prop_ro(
            "edges",
            [](const Planned& self) {
                std::vector<int> edges;
                for (const PlannedStroke& stroke : self.plan.strokes) {
                    edges.push_back(stroke.edge);
                }
                return array_of(std::move(edges));
            },
            "That are turned.")
        .def_prop_ro(
            "strokes",
            [](const Planned& self) {
                Eigen::VectorXd strokes(std::ssize(self.plan.strokes));
                for (Eigen::Index i = 0; i < strokes.size(); ++i) {
                    strokes(i) = self.plan.strokes[static_cast<size_t>(i)].stroke;
                }
                return array_of(std::move(strokes));
            },
            "Change of the unstressed length of each, positive lengthens [m].")
        .def_prop_ro(
            "is_feasible", [](const Planned& self) { return self.plan.is_feasible; },
            "Whether all limits are kept, with the confidence wanted.")
        .def_prop_ro(
            "is_safe", [](const Planned& self) { return self.order.is_safe; },
            "Whether no step of the work breaks a limit that was kept before, with the confidence "
            "wanted.")
        .def_prop_ro(
            "safe_probability", [](const Planned& self) { return self.order.safe_probability; },
            "That no step of the work breaks a limit that was kept before, over the draws; 0 or 1 "
            "without draws.")
        .def_prop_ro(
            "warnings", [](const Planned& self) { return written(self, &plan_warnings); },
            "What forbids to turn by the plan, the worst first: the first lines of its lists.")
        .def_prop_ro(
            "limit_probability", [](const Planned& self) { return self.plan.limit_probability; },
            "That all limits are kept, over the draws; None without.")
        .def_prop_ro(
            "as_built", [](const Planned& self) { return deviation_dict(self.plan.as_built); },
            "Distance from the target [m].")
        .def_prop_ro(
            "planned", [](const Planned& self) { return deviation_dict(self.plan.planned); },
            "Distance from the target then [m].")
        .def_prop_ro(
            "form",
            [](nb::handle_t<Planned> self) {
                return view_of(nb::cast<const Planned&>(self).plan.form, self);
            },
            "Planned (n, 3) [m].")
        .def_prop_ro(
            "tension",
            [](nb::handle_t<Planned> self) {
                return view_of(nb::cast<const Planned&>(self).plan.tensions, self);
            },
            "Planned (m,) [N].")
        .def_ro("net", &Planned::net, "As designed.")
        .def_prop_ro(
            "trust", [](const Planned& self) { return to_string(self.trust.verdict()); },
            "Of the identification that it stands on: 'passed', 'doubtful' or 'failed'.")
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
        .def("to_csv", &plan_csv, "The list that a crew works from.")
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
            "Writes plan.json, and the crews' list where a name is told for it.")
        .def("__repr__", [](const Planned& self) {
            return fmt::format(
                "Plan({} of {} edges, by at most {:.2f} mm; {}; along the normal "
                "{:.2f} mm RMS, {:.2f} mm as built{})",
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
               nb::arg("thread") = nb::none(), nb::arg("accept_failed") = false,
               nb::arg("progress") = nb::none(),
               R"(Strokes that bring the net near a target and keep its limits, and their order.

Args:
    identification: of identify(), with its draws.
    target: form to come near to (n, 3); the nominal one unless told [m].
    stroke: of each edge, at most, either way [m].
    tension: (least, most) that every edge must keep to, either may be None [N].
    edges: that may be turned; the adjustable ones unless told.
    turn: change of length by one turn [m].
    step: smallest part of a turn that can be done, 0.25 say.
    tolerance: turn the fewest edges with which the form comes so near [m].
    confidence: with which limits are to hold over the draws.
    actuator_std: of what is turned, from what was told [m].
    crews: that turn at once.
    thread: 'right' or 'left', of all turnbuckles, where the net does not tell.
    accept_failed: plan on an identification that failed its tests, too; the lists say in their
        first line that they are not to be used.
    progress: called with stage, done, total.)");
}

}  // namespace taut::python
