// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/tuple.h>

#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "dicts.hpp"
#include "states.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/stability.hpp"
#include "taut/statics/tensions.hpp"

namespace taut::python {
namespace {

EquilibriumSettings settings_of(int max_iterations, double relative_tolerance) {
    return {.max_iterations = max_iterations, .relative_tolerance = relative_tolerance};
}

/// A solver with the net that its starts are checked against.
struct Solver {
    Solver(const CableNet& net_, const EquilibriumSettings& settings_)
        : net(net_), settings(settings_), solver(net_, settings_) {}
    CableNet net;
    EquilibriumSettings settings;
    EquilibriumSolver solver;
    std::mutex at_work;  ///< the solver serves one thread at a time
};

void bind_equilibrium(nb::module_& module) {
    nb::class_<Equilibrium> equilibrium(module, "Equilibrium",
                                        "The form a net takes: the minimiser of its energy.");
    make_picklable(equilibrium);
    equilibrium
        .def_prop_ro(
            "form",
            [](nb::handle_t<Equilibrium> self) {
                return view_of(nb::cast<const Equilibrium&>(self).form, self);
            },
            "Supports included (n, 3) [m].")
        .def_prop_ro(
            "unstressed_lengths",
            [](nb::handle_t<Equilibrium> self) {
                return view_of(nb::cast<const Equilibrium&>(self).unstressed_lengths, self);
            },
            "As given; where runs slide, between the nodes after that (m,) [m].")
        .def_prop_ro(
            "status", [](const Equilibrium& self) { return to_string(self.status); },
            "'converged', 'slack mechanism' (some nodes are loose), 'unstable' (struts give way) "
            "or "
            "'iteration limit' (forces do not balance).")
        .def_prop_ro("is_balanced", &Equilibrium::balanced,
                     "Whether the net can stand so: converged, or a slack mechanism.")
        .def_ro("iterations", &Equilibrium::iterations)
        .def_ro("out_of_balance", &Equilibrium::out_of_balance,
                "Largest norm of a nodal force, or where runs slide the largest difference of "
                "tensions that slides no further [N].")
        .def_ro("mean_tension", &Equilibrium::mean_tension, "Over the taut cables [N].")
        .def_prop_ro(
            "slack_edges",
            [](nb::handle_t<Equilibrium> self) {
                return view_of(nb::cast<const Equilibrium&>(self).slack_edges, self);
            },
            "Ascending.")
        .def_prop_ro(
            "energy_decreases",
            [](const Equilibrium& self) { return in_python_types(self.energy_decreases); },
            "Of each iteration; interior-point steps together make one [J].")
        .def("to_dict", &dict_of_fields<Equilibrium>, nb::sig("def to_dict(self) -> dict"),
             "All of it, SI units.")
        .def("__repr__", [](const Equilibrium& self) {
            return fmt::format(
                "Equilibrium({}: {} iterations, out of balance {:.2g} N, {} slack edges)",
                to_string(self.status), self.iterations, self.out_of_balance,
                self.slack_edges.size());
        });
}

}  // namespace

void bind_statics(nb::module_& module) {
    bind_equilibrium(module);
    module.def(
        "solve_equilibrium",
        [](const CableNet& net, const std::optional<ArrayLike>& unstressed_lengths,
           int max_iterations, double relative_tolerance) {
            const EquilibriumSettings settings = settings_of(max_iterations, relative_tolerance);
            const Eigen::VectorXd lengths =
                unstressed_lengths
                    ? vector_argument(*unstressed_lengths, "unstressed_lengths", net.edge_count())
                    : net.unstressed_lengths();
            return without_lock(
                [&] { return EquilibriumSolver(net, settings).solve(lengths, net.nodes()); });
        },
        nb::arg("net"), nb::arg("unstressed_lengths") = nb::none(), nb::kw_only(),
        nb::arg("max_iterations") = EquilibriumSettings().max_iterations,
        nb::arg("relative_tolerance") = EquilibriumSettings().relative_tolerance,
        R"(Equilibrium of a net, from its own nodes.

Args:
    unstressed_lengths: in place of the net's (m,) [m].
    relative_tolerance: largest out-of-balance force that counts as balanced, in mean tensions.

Returns:
    The form with its status: forces that do not balance raise nothing.)");
    nb::class_<Solver> solver(
        module, "EquilibriumSolver",
        "Solves one net for many sets of unstressed lengths. Threads that share one "
        "wait for each other.");
    solver
        .def(
            "__init__",
            [](Solver* self, const CableNet& net, int max_iterations, double relative_tolerance) {
                new (self) Solver(net, settings_of(max_iterations, relative_tolerance));
            },
            nb::arg("net"), nb::kw_only(),
            nb::arg("max_iterations") = EquilibriumSettings().max_iterations,
            nb::arg("relative_tolerance") = EquilibriumSettings().relative_tolerance)
        .def("__getstate__",
             [](const Solver& self) {
                 return std::tuple(self.net, self.settings.max_iterations,
                                   self.settings.relative_tolerance);
             })
        .def("__setstate__",
             [](Solver& self, const std::tuple<CableNet, int, double>& state) {
                 const auto& [net, max_iterations, relative_tolerance] = state;
                 new (&self) Solver(net, settings_of(max_iterations, relative_tolerance));
             })
        .def(
            "solve",
            [](Solver& self, const ArrayLike& unstressed_lengths,
               const std::optional<ArrayLike>& start) {
                const Eigen::VectorXd lengths = vector_argument(
                    unstressed_lengths, "unstressed_lengths", self.net.edge_count());
                const Points from = start ? points_argument(*start, "start", self.net.node_count())
                                          : self.net.nodes();
                return without_lock([&] {
                    const std::scoped_lock alone(self.at_work);
                    return self.solver.solve(lengths, from);
                });
            },
            nb::arg("unstressed_lengths"), nb::arg("start") = nb::none(),
            R"(The form for these lengths.

Args:
    unstressed_lengths: (m,) [m].
    start: form to begin from (n, 3), by default the net's nodes [m].)");
    refuse_other_arguments(solver);
    nb::class_<FormSensitivity> sensitivity(
        module, "FormSensitivity",
        "First and second derivatives of the equilibrium form with "
        "respect to unstressed lengths; factorised once.");
    sensitivity
        .def(
            "__init__",
            [](FormSensitivity* self, const CableNet& net, const ArrayLike& unstressed_lengths,
               const ArrayLike& form) {
                const Eigen::VectorXd lengths =
                    vector_argument(unstressed_lengths, "unstressed_lengths", net.edge_count());
                const Points places = points_argument(form, "form", net.node_count());
                constexpr double balanced = 1e-3;
                const Imbalance imbalance = imbalance_of(net, lengths, places);
                if (imbalance.mean_tension > 0.0 && imbalance.share() > balanced) {
                    throw nb::value_error(
                        fmt::format("form: is no equilibrium of unstressed_lengths: up to {:.3g} N "
                                    "are out of balance, the mean tension is {:.3g} N",
                                    imbalance.largest, imbalance.mean_tension)
                            .c_str());
                }
                without_lock([&] { return new (self) FormSensitivity(net, lengths, places); });
            },
            nb::arg("net"), nb::arg("unstressed_lengths"), nb::arg("form"))
        .def(
            "apply",
            [](const FormSensitivity& self, const ArrayLike& length_changes) {
                const Eigen::VectorXd changes =
                    vector_argument(length_changes, "length_changes", -1);
                return array_of(without_lock([&] { return self.apply(changes); }));
            },
            nb::arg("length_changes"),
            "Change of the free coordinates x1, y1, z1, x2, ... to first order (3 n_I,) [m], for "
            "changes of all unstressed lengths (m,) [m].")
        .def(
            "apply_transposed",
            [](const FormSensitivity& self, const ArrayLike& gradient) {
                const Eigen::VectorXd of_form = vector_argument(gradient, "gradient", -1);
                return array_of(without_lock([&] { return self.apply_transposed(of_form); }));
            },
            nb::arg("gradient"),
            "Gradient with respect to all unstressed lengths (m,) of a function whose gradient "
            "with respect to the free coordinates is this (3 n_I,).")
        .def(
            "net_gradient",
            [](const FormSensitivity& self, const ArrayLike& gradient) {
                const Points of_form = points_argument(gradient, "gradient", -1);
                NetGradient found = without_lock([&] { return self.net_gradient(of_form); });
                nb::dict result;
                result["unstressed_lengths"] = array_of(std::move(found.unstressed_lengths));
                result["axial_stiffness"] = array_of(std::move(found.axial_stiffness));
                result["loads"] = array_of(std::move(found.loads));
                result["nodes"] = array_of(std::move(found.nodes));
                return result;
            },
            nb::arg("gradient"),
            "Gradients with respect to 'unstressed_lengths' (m,), 'axial_stiffness' (m,), 'loads' "
            "(n, 3) and 'nodes' (n, 3), the places of supports, of a function whose gradient with "
            "respect to the form is this (n, 3). 0 by what the form does not depend on.")
        .def(
            "apply_second",
            [](const FormSensitivity& self, const ArrayLike& length_changes,
               const ArrayLike& more_changes) {
                const Eigen::VectorXd changes =
                    vector_argument(length_changes, "length_changes", -1);
                const Eigen::VectorXd more = vector_argument(more_changes, "more_changes", -1);
                return array_of(without_lock([&] { return self.apply_second(changes, more); }));
            },
            nb::arg("length_changes"), nb::arg("more_changes"),
            "Second derivative of the free coordinates (3 n_I,) [m] along two changes of all "
            "unstressed lengths (m,) [m].")
        .def(
            "apply_second_transposed",
            [](const FormSensitivity& self, const ArrayLike& gradient,
               const ArrayLike& length_changes) {
                const Eigen::VectorXd of_form = vector_argument(gradient, "gradient", -1);
                const Eigen::VectorXd changes =
                    vector_argument(length_changes, "length_changes", -1);
                return array_of(
                    without_lock([&] { return self.apply_second_transposed(of_form, changes); }));
            },
            nb::arg("gradient"), nb::arg("length_changes"),
            "Gradient with respect to all unstressed lengths (m,) of gradient @ "
            "apply(length_changes), for a constant gradient (3 n_I,) and changes (m,).")
        .def(
            "columns",
            [](const FormSensitivity& self, const ArrayLike& edges) {
                const std::vector<int> wanted = indices_argument(edges, "edges");
                return array_of_columns(without_lock([&] { return self.columns(wanted); }));
            },
            nb::arg("edges"),
            "Of each edge, a row each: change of the free coordinates by its length (edges, 3 n_I) "
            "[m/m].");
    refuse_other_arguments(sensitivity);
    module.def(
        "tensions",
        [](const CableNet& net, const ArrayLike& unstressed_lengths, const ArrayLike& form) {
            return array_of(tensions_of(
                net, vector_argument(unstressed_lengths, "unstressed_lengths", net.edge_count()),
                points_argument(form, "form", net.node_count())));
        },
        nb::arg("net"), nb::arg("unstressed_lengths"), nb::arg("form"),
        "Tensions of all edges (m,) [N] at a form (n, 3) [m].");
    module.def(
        "edge_lengths",
        [](const CableNet& net, const ArrayLike& form) {
            return array_of(edge_lengths(net, points_argument(form, "form", net.node_count())));
        },
        nb::arg("net"), nb::arg("form"), "Lengths of all edges (m,) at a form (n, 3) [m].");
    module.def(
        "smallest_stiffness",
        [](const CableNet& net, const std::optional<ArrayLike>& unstressed_lengths,
           const std::optional<ArrayLike>& form) {
            return smallest_stiffness(
                net,
                unstressed_lengths
                    ? vector_argument(*unstressed_lengths, "unstressed_lengths", net.edge_count())
                    : net.unstressed_lengths(),
                form ? points_argument(*form, "form", net.node_count()) : net.nodes());
        },
        nb::arg("net"), nb::arg("unstressed_lengths") = nb::none(), nb::arg("form") = nb::none(),
        "Smallest eigenvalue of the stiffness of the free nodes, by default at the net's nodes and "
        "lengths: below zero struts give way [N/m].");
}

}  // namespace taut::python
