// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <filesystem>
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
#include "taut/adjustment/plan_turns.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/results/plan_files.hpp"

namespace taut::python {
namespace {

/// A form, the name of a file, or a surface of vertices and triangles.
class TargetLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(TargetLike, nb::object,
              "numpy.typing.ArrayLike | str | os.PathLike | tuple[numpy.typing.ArrayLike, "
              "numpy.typing.ArrayLike]",
              is_any)
};

/// Least and most, either of which may be left out; of all edges, or by group.
class RangeLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(
        RangeLike, nb::object,
        "tuple[float | str | None, float | str | None] | dict[str | None, tuple[float | str | "
        "None, float | str | None]]",
        is_any)
};

/// The longest stroke, or the shortest and longest by edge.
class StrokeLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(StrokeLike, nb::object, "float | str | dict[int, tuple[float | str, float | str]]",
              is_any)
};

/// A force of all supports, or by group.
class ForceLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(ForceLike, nb::object, "float | str | dict[str | None, float | str]", is_any)
};

/// A tension, or tension and tolerance, of all edges, or by group or edge; or a tension of each
/// edge.
class TensionLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(
        TensionLike, nb::object,
        "float | str | tuple[float | str, float | str] | numpy.typing.NDArray | dict[str | int "
        "| None, float | str | tuple[float | str, float | str]]",
        is_any)
};

/// Arrays by their names.
class ArraysByName : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(ArraysByName, nb::object, "dict[str, numpy.typing.ArrayLike]", is_any)
};

/// What plan_to_json(), plan_to_csv() or plan_warnings() make of a plan.
template <class Write>
auto written(const Planned& planned, Write write) {
    const FormTarget target = target_of(planned.net, planned.target);
    return write(PlanRecord{.net = &planned.net,
                            .built = &planned.built,
                            .trust = &planned.trust,
                            .target = &target,
                            .turns = &planned.turns});
}

std::string plan_json(const Planned& planned) {
    return written(planned, [](const PlanRecord& record) { return plan_to_json(record); });
}

std::string plan_csv(const Planned& planned) {
    return written(planned, &plan_to_csv);
}

const Plan& plan_of(const Planned& planned) {
    return planned.turns.plan;
}

/// Calls `take` with the group and each value of a dict, or with no group and the one value.
template <class Value, class Take>
void for_each_group(nb::handle given, const char* name, const char* expected, Take take) {
    if (!nb::isinstance<nb::dict>(given)) {
        take(std::nullopt, of_type<Value>(given, name, expected));
        return;
    }
    for (const auto& [group, value] : nb::borrow<nb::dict>(given)) {
        take(of_type<std::optional<std::string>>(group, name, "names of groups, or None for all"),
             of_type<Value>(value, name, expected));
    }
}

using Pair = std::pair<nb::object, nb::object>;
using Range = std::pair<std::optional<nb::object>, std::optional<nb::object>>;

void add_tension(PlanRequest& request, const std::optional<RangeLike>& given, const char* name,
                 bool is_part) {
    if (!given) {
        return;
    }
    const auto bound = [&](const std::optional<nb::object>& value) {
        const auto number = [&] {
            return is_part ? of_type<double>(*value, name, "a part from 0 to 1")
                           : force_given(*value, name);
        };
        return value ? std::optional(TensionBound{.value = number(), .is_part = is_part})
                     : std::nullopt;
    };
    for_each_group<Range>(*given, name, "(least, most), either of which may be None",
                          [&](std::optional<std::string> group, const Range& range) {
                              const TensionRange given_range{.least = bound(range.first),
                                                             .most = bound(range.second),
                                                             .group = std::move(group)};
                              try {
                                  check_tension_range(given_range);
                              } catch (const RequestError& error) {
                                  throw RequestError(name, error.problem());
                              }
                              request.tension.push_back(given_range);
                          });
}

void add_strokes(PlanRequest& request, const std::optional<StrokeLike>& given) {
    if (!given) {
        return;
    }
    if (!nb::isinstance<nb::dict>(*given)) {
        request.stroke =
            quantity_given(*given, "stroke", parse_length, "a length, or a dict of edges");
        return;
    }
    for (const auto& [edge, range] : nb::borrow<nb::dict>(*given)) {
        const auto [shortest, longest] =
            of_type<Pair>(range, "stroke", "(shortest, longest) of each edge");
        request.stroke_ranges.push_back({.edge = of_type<int>(edge, "stroke", "indices of edges"),
                                         .shortest = length_given(shortest, "stroke"),
                                         .longest = length_given(longest, "stroke")});
    }
    if (request.stroke_ranges.empty()) {
        throw nb::value_error("stroke: names no edge, expected those that may be turned");
    }
}

/// A tension, or tension and tolerance [N].
GivenTension tension_argument(nb::handle value) {
    const char* const name = "target_tension";
    if (!nb::isinstance<nb::tuple>(value)) {
        return {.tension =
                    quantity_given(value, name, parse_force, "tensions, or (tension, tolerance)")};
    }
    const auto [tension, tolerance] = of_type<Pair>(value, name, "(tension, tolerance)");
    return {.tension = force_given(tension, name),
            .tolerance = {.value = force_given(tolerance, name)}};
}

void add_target_tensions(PlanRequest& request, const CableNet& net, nb::handle given) {
    const char* const name = "target_tension";
    if (nb::isinstance<nb::dict>(given)) {
        for (const auto& [key, value] : nb::borrow<nb::dict>(given)) {
            GivenTension one = tension_argument(value);
            if (nb::isinstance<nb::str>(key)) {
                one.group = nb::cast<std::string>(key);
            } else if (!key.is_none()) {
                one.edge = of_type<int>(key, name, "groups, indices of edges, or None for all");
            }
            request.target_tension.push_back(std::move(one));
        }
    } else if (nb::hasattr(given, "__len__") && !nb::isinstance<nb::tuple>(given)) {
        const Eigen::VectorXd tensions = vector_or_number(given, name, net.edge_count());
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            if (!std::isnan(tensions(edge))) {
                GivenTension& one = request.target_tension.emplace_back();
                one.tension = tensions(edge);
                one.edge = edge;
            }
        }
    } else {
        request.target_tension.push_back(tension_argument(given));
    }
    if (request.target_tension.empty()) {
        throw nb::value_error("target_tension: got none, expected those of one edge or more");
    }
}

/// A surface given as (vertices, triangles).
GivenTarget surface_argument(nb::handle vertices, nb::handle triangles, double unit) {
    const nb::object corners = nb::module_::import_("numpy").attr("asarray")(triangles);
    const auto shape = nb::cast<std::vector<size_t>>(corners.attr("shape"));
    if (shape.size() != 2 || shape[1] != 3 || shape[0] == 0) {
        throw nb::value_error("target: its triangles are not (f, 3), expected three vertices each");
    }
    const std::vector<int> flat = indices_argument(corners.attr("ravel")(), "target");
    GivenTarget target{.points = unit * points_argument(vertices, "target", -1)};
    for (size_t k = 0; k < flat.size(); k += 3) {
        target.triangles.push_back({flat[k], flat[k + 1], flat[k + 2]});
    }
    return target;
}

GivenTarget target_argument(const CableNet& net, const std::optional<TargetLike>& given,
                            const std::string& unit_name) {
    const std::optional<double> unit = length_of_unit(unit_name);
    if (!unit) {
        throw nb::value_error(
            fmt::format("target_unit: got '{}', expected a unit such as 'mm'", unit_name).c_str());
    }
    if (!given) {
        return read_target(net, {}, *unit);
    }
    if (nb::isinstance<nb::str>(*given) || nb::hasattr(*given, "__fspath__")) {
        return read_target(net, nb::cast<std::filesystem::path>(*given), *unit);
    }
    if (nb::isinstance<nb::tuple>(*given) && nb::len(*given) == 2 && net.node_count() > 2) {
        return surface_argument((*given)[0], (*given)[1], *unit);
    }
    if (*unit != 1.0) {
        throw nb::value_error("target_unit: is for a surface, which the target is not");
    }
    return {.points = points_argument(*given, "target", net.node_count())};
}

/// One number for all nodes or one of each, along the normal and across it.
std::vector<NodeWeights> weights_argument(const CableNet& net,
                                          const std::pair<ArrayLike, ArrayLike>& given) {
    const Eigen::VectorXd normal = vector_or_number(given.first, "weights", net.node_count());
    const Eigen::VectorXd tangential = vector_or_number(given.second, "weights", net.node_count());
    std::vector<NodeWeights> weights;
    for (const int node : net.free_nodes()) {
        weights.push_back({.node = node, .normal = normal(node), .tangential = tangential(node)});
    }
    return weights;
}

FormObjective objective_named(const std::string& name) {
    if (name != "rms" && name != "largest") {
        throw nb::value_error(
            fmt::format("objective: got '{}', expected 'rms' or 'largest'", name).c_str());
    }
    return name == "rms" ? FormObjective::rms : FormObjective::largest;
}

/// By Python's warnings.
void warn(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        nb::module_::import_("warnings")
            .attr("warn")("target: " + warning, nb::arg("stacklevel") = 2);
    }
}

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
    if (target_tension) {
        add_target_tensions(request, net, *target_tension);
    }
    add_tension(request, tension, "tension", false);
    add_tension(request, tension_part, "tension_part", true);
    if (reaction) {
        for_each_group<nb::object>(
            *reaction, "reaction", "a force",
            [&](std::optional<std::string> group, const nb::object& upper) {
                request.reaction.push_back(
                    {.upper = force_given(upper, "reaction"), .group = std::move(group)});
            });
    }
    if (load_cases) {
        for_each_group<ArrayLike>(
            *load_cases, "load_cases", "loads by name",
            [&](std::optional<std::string> name, const ArrayLike& loads) {
                request.load_cases.push_back(
                    {.name = name.value_or("load_cases"),
                     .loads = points_argument(loads, "load_cases", net.node_count())});
            });
    }
    GivenTarget given = target_argument(net, target, target_unit);
    given.objective = objective_named(objective);
    if (weights) {
        given.node_weights = weights_argument(net, *weights);
    }
    const FormTarget form = target_of(net, given);
    warn(target_warnings(net, form));
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

void bind_plan(nb::module_& module) {
    nb::class_<Planned> result(
        module, "Plan",
        "Which turnbuckle to turn how far, in which order, and the form and tensions that follow.");
    make_picklable(result);
    bind_fields<Plan>(
        result, &plan_of,
        {{"as_built",
          "Deviation from the target before anything is turned [m]: mean, max and rmse in 3D, "
          "normal_mean, normal_max and normal_rmse along the normal of the target."},
         {"planned", "The same after all strokes [m]."},
         {"unconstrained", "The same after strokes without limits, no edge slack [m]."},
         {"target_tensions",
          "Of each target tension, ascending by edge: edge, target, tolerance, as_built, planned, "
          "unconstrained, of_any_form (unlimited strokes without regard to the form) [N] of the "
          "estimate; mean and std [N] over the samples and probability that it is within the "
          "tolerance, None without samples; obstacle, what keeps it out of the tolerance: 'none', "
          "'limits', 'form' or 'turnbuckles' (these cannot reach it)."},
         {"normal_std",
          "Standard deviation of the planned form along the normal, root mean square over the "
          "nodes; 0 without posterior samples [m]."},
         {"suggested_targets",
          "Targets whose survey would show most of the planned form, the best first, at most ten; "
          "empty without suggest_targets. Of each: node, and normal_std after a survey of this and "
          "those before it [m]."},
         {"form_std",
          "Standard deviations of the planned form (n, 3); 0 without posterior samples [m]."},
         {"form_covariance",
          "Covariance of each node's place in the planned form, a list of (3, 3) arrays; empty "
          "without posterior samples [m2]."},
         {"tension_lower",
          "Lower ends of the 95 % intervals of the planned tensions (m,); empty without posterior "
          "samples [N]."},
         {"tension_upper", "Upper ends of the same (m,) [N]."},
         {"effective_limits",
          "The limits given less the margin for uncertainty [N]: of the net's loads, then of each "
          "load case, lower and upper of each force, reactions behind tensions."},
         {"draws", "Number of posterior samples in which limits were kept; 0: the estimate alone."},
         {"draws_needed",
          "Number of these that must keep all limits for the confidence required; 0 without."},
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
            "edges", [](const Planned& self) { return edges_of_each(self.turns.plan.strokes); },
            "Edges that are turned, ascending (k,).")
        .def_prop_ro(
            "strokes",
            [](const Planned& self) {
                return array_of_each(self.turns.plan.strokes, &PlannedStroke::stroke);
            },
            "Change of the unstressed length of each (k,), positive lengthens [m].")
        .def_prop_ro(
            "form",
            [](nb::handle_t<Planned> self) {
                return view_of(plan_of(nb::cast<const Planned&>(self)).form, self);
            },
            "Planned form (n, 3) [m].")
        .def_prop_ro(
            "tension",
            [](nb::handle_t<Planned> self) {
                return view_of(plan_of(nb::cast<const Planned&>(self)).tensions, self);
            },
            "Planned tensions (m,) [N].")
        .def_prop_ro(
            "order", [](const Planned& self) { return in_python_types(self.turns.order); },
            "Order of the work: turnings, of each its edge, stroke [m], pass, crew, step (those of "
            "one step are made at once), tension [N] and natural frequency of the edge then (0 "
            "without mass) [Hz]; passes; stages, of each its name, part, last step, least_tension, "
            "most_tension [N], and safe_probability until then; walk of all crews [m]; "
            "safe_probability and is_safe; worst, the step (-1: none) with the worst breach of a "
            "limit.")
        .def_prop_ro(
            "suggested_adjustable",
            [](const Planned& self) { return in_python_types(self.turns.suggested_adjustable); },
            "Edges that would help most if they were made adjustable, each with those before it: "
            "edge, stroke and normal_rmse_after [m], tension_rmse_after of the target tensions "
            "[tolerances]; None without suggest_adjustable.")
        .def_prop_ro(
            "is_safe", [](const Planned& self) { return self.turns.order.is_safe; },
            "Whether no step of the work breaks a limit that was kept before, with the confidence "
            "required.")
        .def_prop_ro(
            "safe_probability",
            [](const Planned& self) { return self.turns.order.safe_probability; },
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
                self.turns.plan.strokes.size(), self.turns.options.edges.size(),
                1e3 * self.turns.plan.largest_stroke(),
                self.turns.plan.is_feasible ? "limits are kept" : "LIMITS ARE BROKEN",
                1e3 * self.turns.plan.planned.normal_rmse,
                1e3 * self.turns.plan.as_built.normal_rmse,
                self.trust.verdict() == Trust::Verdict::passed
                    ? ""
                    : fmt::format("; the identification is {}", to_string(self.trust.verdict())));
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
