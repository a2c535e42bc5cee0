// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nanobind/nanobind.h>

#include <optional>
#include <string>

#include "arrays.hpp"
#include "bindings.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/design/force_density.hpp"
#include "taut/design/unstressed_lengths.hpp"

namespace taut::python {

void bind_design(nb::module_& module) {
    module.def(
        "builtin_net", [](const std::string& name) { return builtin_net(name); }, nb::arg("name"),
        "'hilo-quarter', 'steel-roof', 'cable-dome', 'spoke-wheel', 'tensegrity-simplex', "
        "'sliding-ridge', or 'hypar:ROWSxCOLUMNS'.");
    module.def("hilo_quarter", &hilo_quarter,
               "A net with the counts of the paper's prototype: 300 free nodes, 536 interior and "
               "128 adjustable edges.");
    module.def("steel_roof", &steel_roof, "A roof of spiral strands on an elliptic ring.");
    module.def("cable_dome", &cable_dome,
               "A dome of ridge cables over flying struts, with hoops and a ring of supports.");
    module.def("spoke_wheel", &spoke_wheel,
               "A roof like a bicycle wheel: a rim of struts on elastic supports, and a mast.");
    module.def("tensegrity_simplex", &tensegrity_simplex,
               "The three struts and nine cables of a laboratory's simplex.");
    module.def("sliding_ridge", &sliding_ridge,
               "A ridge of cable that slides over two masts and through its clamps.");
    module.def("hypar", &hypar, nb::arg("rows"), nb::arg("columns"),
               "A hyperbolic paraboloid of rows x columns free nodes, 1 to 1000 each.");
    module.def(
        "form_from_force_densities",
        [](const ArrayLike& nodes, const ArrayLike& supports, const ArrayLike& edges,
           const ArrayLike& force_densities, const std::optional<ArrayLike>& loads) {
            const Points places = points_argument(nodes, "nodes", -1);
            const std::vector<Edge> pairs = edges_argument(edges, "edges");
            return array_of(form_from_force_densities(
                places, indices_argument(supports, "supports"), pairs,
                vector_or_number(force_densities, "force_densities",
                                 static_cast<Eigen::Index>(pairs.size())),
                loads ? points_argument(*loads, "loads", places.cols()) : Points(3, 0)));
        },
        nb::arg("nodes"), nb::arg("supports"), nb::arg("edges"), nb::arg("force_densities"),
        nb::arg("loads") = nb::none(),
        R"(The form in which edges of given force densities balance each other and the loads.

Args:
    nodes: (n, 3), of which only the supports' are used [m].
    supports: nodes.
    edges: (m, 2) pairs of nodes.
    force_densities: (m,), or one number [N/m].
    loads: (n, 3) [N].

Returns:
    (n, 3), supports included [m].)");
    module.def(
        "unstressed_lengths_for",
        [](const ArrayLike& lengths, const ArrayLike& tensions, const ArrayLike& axial_stiffness) {
            const Eigen::VectorXd stretched = vector_argument(lengths, "lengths", -1);
            return array_of(unstressed_lengths_for(
                stretched, vector_or_number(tensions, "tensions", stretched.size()),
                vector_or_number(axial_stiffness, "axial_stiffness", stretched.size())));
        },
        nb::arg("lengths"), nb::arg("tensions"), nb::arg("axial_stiffness"),
        "l / (1 + T/EA): the lengths (m,) [m] to which edges are cut so that they carry tensions "
        "[N] when stretched to lengths [m].");
}

}  // namespace taut::python
