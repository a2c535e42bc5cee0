// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "dicts.hpp"
#include "documents.hpp"
#include "planned.hpp"
#include "states.hpp"
#include "taut/files/file.hpp"
#include "taut/results/plan_files.hpp"

namespace taut::python {
namespace {

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

/// What plan.json holds under a key.
auto part_of_json(const char* key) {
    return [key](const Planned& self) { return nb::object(dict_of(plan_json(self))[key]); };
}

const Plan& plan_of(const Planned& planned) {
    return planned.turns.plan;
}

}  // namespace

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
         {"is_feasible",
          "Whether all limits are kept, with the confidence required; without posterior samples "
          "by the estimate alone."},
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
        .def_prop_ro("turns", part_of_json("turns"), nb::sig("def turns(self) -> list"),
                     "What to turn, one entry a turnbuckle and pass: edge and edge_id, stroke [m], "
                     "turns, action and rotation, pass, crew and step of the work, reading_after "
                     "[m], tension_after_step and tension_after [N], frequency_after_step [Hz].")
        .def_prop_ro("options", part_of_json("options"), nb::sig("def options(self) -> dict"),
                     "What the plan was made with, as plan.json holds it.")
        .def_prop_ro(
            "largest_stroke", [](const Planned& self) { return plan_of(self).largest_stroke(); },
            "The longest stroke in absolute value [m].")
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
            [](const Planned& self) {
                return self.turns.plan.draws > 0 ? std::optional(self.turns.order.safe_probability)
                                                 : std::nullopt;
            },
            "Probability that no step of the work breaks a limit that was kept before; None "
            "without posterior samples, where order has 0 or 1.")
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
                !self.turns.plan.is_feasible ? "LIMITS ARE BROKEN"
                : self.turns.plan.draws == 0 ? "limits are kept by the estimate, not surely"
                                             : "limits are kept",
                1e3 * self.turns.plan.planned.normal_rmse,
                1e3 * self.turns.plan.as_built.normal_rmse,
                self.trust.verdict() == Trust::Verdict::passed
                    ? ""
                    : fmt::format("; the identification is {}", to_string(self.trust.verdict())));
        });
}

}  // namespace taut::python
