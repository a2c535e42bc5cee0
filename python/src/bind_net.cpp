// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/variant.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "documents.hpp"
#include "given.hpp"
#include "states.hpp"
#include "taut/files/file.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/net/cable_runs.hpp"
#include "taut/net/tension_law.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/frame.hpp"
#include "taut/statics/plausibility.hpp"

namespace taut::python {
namespace {

using Names = std::vector<std::string>;

/// @param places of some of them; null: those of their nodes
void add_elastic_supports(const std::map<int, ArrayLike>& stiffnesses,
                          const std::map<int, ArrayLike>* places, CableNetData& data) {
    for (const auto& [node, given] : stiffnesses) {
        const std::string name = fmt::format("support_stiffness[{}]", node);
        if (std::ranges::find(data.supports, node) == data.supports.end() || node < 0 ||
            node >= data.nodes.cols()) {
            throw nb::value_error(fmt::format("{}: is not among the supports", name).c_str());
        }
        ElasticSupport support{.node = node, .place = data.nodes.col(node)};
        if (numbers(given, name).ndim() == 2) {
            support.stiffness = points_argument(given, name, 3).transpose();
        } else {
            support.stiffness = vector_or_number(given, name, 3).asDiagonal();
        }
        std::erase(data.supports, node);
        data.elastic_supports.push_back(support);
    }
    for (const auto& [node, given] : places != nullptr ? *places : std::map<int, ArrayLike>()) {
        const std::string name = fmt::format("support_place[{}]", node);
        const auto found = std::ranges::find(data.elastic_supports, node, &ElasticSupport::node);
        if (found == data.elastic_supports.end()) {
            throw nb::value_error(fmt::format("{}: is no node of support_stiffness", name).c_str());
        }
        found->place = place_argument(given, name);
    }
}

/// None, "mass", one number for all cables without a tension law, or one for each edge.
void set_sag_weights(const std::variant<std::monostate, std::string, ArrayLike>& given,
                     CableNetData& data) {
    if (const auto* const word = std::get_if<std::string>(&given)) {
        if (*word != "mass") {
            throw nb::value_error("sag_weight: expected 'mass', one number, or one for each edge");
        }
        CableNetData checked = data;
        data.sag_weight = sag_weights_by_mass(CableNet(std::move(checked)).data());
    } else if (const auto* const values = std::get_if<ArrayLike>(&given)) {
        data.sag_weight = vector_or_number(*values, "sag_weight", std::ssize(data.edges));
        if (numbers(*values, "sag_weight").ndim() == 0 && data.sag_weight.size() > 0) {
            data.sag_weight = equal_sag_weights(data, data.sag_weight(0));
        }
    }
}

/// A word for each edge, or one for all.
void set_cable_ends(const std::variant<std::string, Names>& given, CableNetData& data) {
    const auto* const one = std::get_if<std::string>(&given);
    for (const std::string& word :
         one != nullptr ? Names(data.edges.size(), *one) : std::get<Names>(given)) {
        const std::optional<CableEnds> ends = cable_ends_named(word);
        if (!ends) {
            throw nb::value_error(
                fmt::format("cable_ends: got '{}', expected 'hinged', 'fixed' or 'unknown'", word)
                    .c_str());
        }
        data.cable_ends.push_back(*ends);
    }
}

void make_net(CableNet* self, const ArrayLike& nodes, const ArrayLike& supports,
              const ArrayLike& edges, const ArrayLike& axial_stiffness,
              const ArrayLike& unstressed_lengths, const std::optional<ArrayLike>& adjustable,
              const std::optional<ArrayLike>& loads, const std::string& name, const Names& node_ids,
              const Names& edge_ids, const std::vector<TensionLaw>& tension_laws,
              const std::optional<ArrayLike>& tension_law,
              const std::map<std::string, ArrayLike>& groups, const std::optional<ArrayLike>& mass,
              const std::optional<ArrayLike>& expansion,
              const std::optional<ArrayLike>& breaking_load, const Names& thread,
              const std::map<std::string, ArrayLike>& runs,
              const std::map<std::string, ArrayLike>& slides_at,
              const std::map<std::string, double>& friction,
              const std::optional<ArrayLike>& bending_stiffness,
              const std::map<int, ArrayLike>& support_stiffness,
              const std::variant<std::string, std::map<int, ArrayLike>>& support_place,
              const Names& kind, const std::optional<ArrayLike>& buckling_load,
              const std::variant<std::monostate, std::string, ArrayLike>& sag_weight,
              const std::variant<std::string, Names>& cable_ends) {
    CableNetData data;
    data.name = name;
    data.nodes = points_argument(nodes, "nodes", -1);
    data.supports = indices_argument(supports, "supports");
    data.edges = edges_argument(edges, "edges");
    const auto count = static_cast<Eigen::Index>(data.edges.size());
    data.axial_stiffness = vector_or_number(axial_stiffness, "axial_stiffness", count);
    data.unstressed_lengths = vector_argument(unstressed_lengths, "unstressed_lengths", count);
    data.adjustable = adjustable ? indices_argument(*adjustable, "adjustable")
                                 : edges_at_supports(data.edges, data.supports);
    if (loads) {
        data.loads = points_argument(*loads, "loads", data.nodes.cols());
    }
    data.node_ids = node_ids;
    data.edge_ids = edge_ids;
    data.tension_laws = tension_laws;
    if (tension_law) {
        data.tension_law = indices_argument(*tension_law, "tension_law");
    }
    for (const auto& [group, members] : groups) {
        data.groups[group] = indices_argument(members, fmt::format("groups['{}']", group));
    }
    const auto of_edges = [&](const std::optional<ArrayLike>& values, const char* which) {
        return values ? vector_or_number(*values, which, count) : Eigen::VectorXd();
    };
    data.mass = of_edges(mass, "mass");
    data.expansion = of_edges(expansion, "expansion");
    data.breaking_load = of_edges(breaking_load, "breaking_load");
    data.bending_stiffness = of_edges(bending_stiffness, "bending_stiffness");
    for (const std::string& one : kind) {
        if (one != "cable" && one != "strut") {
            throw nb::value_error(
                fmt::format("kind: got '{}', expected 'cable' or 'strut'", one).c_str());
        }
        data.kind.push_back(one == "strut" ? EdgeKind::strut : EdgeKind::cable);
    }
    if (buckling_load) {
        data.buckling_load = vector_or_number(*buckling_load, "buckling_load", count);
        for (int e = 0; numbers(*buckling_load, "buckling_load").ndim() == 0 && e < count; ++e) {
            if (e >= std::ssize(data.kind) || data.kind[e] != EdgeKind::strut) {
                data.buckling_load(e) = std::numeric_limits<double>::infinity();
            }
        }
    }
    set_sag_weights(sag_weight, data);
    set_cable_ends(cable_ends, data);
    for (const std::string& one : thread) {
        data.thread.push_back(thread_named(one));
    }
    for (const auto& [run, members] : runs) {
        data.runs.push_back(
            {.name = run, .edges = indices_argument(members, fmt::format("runs['{}']", run))});
    }
    const auto run_named = [&](const char* argument, const std::string& name) -> CableRun& {
        const auto found = std::ranges::find(data.runs, name, &CableRun::name);
        if (found == data.runs.end()) {
            throw nb::value_error(
                fmt::format("{}: got '{}', expected one of runs", argument, name).c_str());
        }
        return *found;
    };
    for (const auto& [run, nodes] : slides_at) {
        run_named("slides_at", run).slides_at =
            indices_argument(nodes, fmt::format("slides_at['{}']", run));
    }
    for (const auto& [run, coefficient] : friction) {
        run_named("friction", run).friction = coefficient;
    }
    const auto* const places = std::get_if<std::map<int, ArrayLike>>(&support_place);
    if (places == nullptr && std::get<std::string>(support_place) != "balanced") {
        throw nb::value_error("support_place: expected 'balanced' or places by node");
    }
    add_elastic_supports(support_stiffness, places, data);
    CableNet net(std::move(data));
    new (self) CableNet(places == nullptr ? with_supports_in_balance(net) : net);
}

void bind_tension_law(nb::module_& module) {
    nb::class_<TensionLaw> law(
        module, "TensionLaw",
        "Tension over strain, straight between points, the first of which is (0, 0).");
    make_picklable(law);
    law.def(
           "__init__",
           [](TensionLaw* self, const ArrayLike& strain, const ArrayLike& tension,
              const std::string& name) {
               TensionLaw law{.name = name,
                              .strain = vector_argument(strain, "strain", -1),
                              .tension = vector_argument(tension, "tension", -1)};
               if (const std::string problem = problem_of(law); !problem.empty()) {
                   throw nb::value_error(("a tension law " + problem).c_str());
               }
               new (self) TensionLaw(std::move(law));
           },
           nb::arg("strain"), nb::arg("tension"), nb::arg("name") = "",
           "strain (k,) ascending from 0 [-]; tension (k,) from 0 [N].")
        .def_ro("name", &TensionLaw::name)
        .def_prop_ro("strain",
                     [](nb::handle_t<TensionLaw> self) {
                         return view_of(nb::cast<TensionLaw&>(self).strain, self);
                     })
        .def_prop_ro("tension",
                     [](nb::handle_t<TensionLaw> self) {
                         return view_of(nb::cast<TensionLaw&>(self).tension, self);
                     })
        .def("__repr__", [](const TensionLaw& law) {
            return fmt::format("TensionLaw({} points, up to {:.4g} N)", law.strain.size(),
                               law.tension.maxCoeff());
        });
    refuse_other_arguments(law);
}

/// A property that is a view of what the net holds.
template <auto Get>
auto view() {
    return [](nb::handle_t<CableNet> self) {
        return view_of((nb::cast<const CableNet&>(self).*Get)(), self);
    };
}

/// A property of elastic supports: a dict by node.
template <class Get>
auto by_node(Get get) {
    return [get](const CableNet& self) {
        nb::dict result;
        for (const ElasticSupport& support : self.elastic_supports()) {
            result[nb::int_(support.node)] = get(support);
        }
        return result;
    };
}

}  // namespace

void bind_net(nb::module_& module) {
    bind_tension_law(module);
    nb::class_<CableNet> net(
        module, "CableNet",
        "A tensioned cable net: nodes, of which some are supports, and edges with their axial "
        "stiffness and unstressed lengths. Immutable, and valid by construction.");
    net.def("__init__", &make_net, nb::arg("nodes"), nb::arg("supports"), nb::arg("edges"),
            nb::arg("axial_stiffness"), nb::arg("unstressed_lengths"), nb::kw_only(),
            nb::arg("adjustable") = nb::none(), nb::arg("loads") = nb::none(), nb::arg("name") = "",
            nb::arg("node_ids") = Names(), nb::arg("edge_ids") = Names(),
            nb::arg("tension_laws") = std::vector<TensionLaw>(),
            nb::arg("tension_law") = nb::none(),
            nb::arg("groups") = std::map<std::string, ArrayLike>(), nb::arg("mass") = nb::none(),
            nb::arg("expansion") = nb::none(), nb::arg("breaking_load") = nb::none(),
            nb::arg("thread") = Names(), nb::arg("runs") = std::map<std::string, ArrayLike>(),
            nb::arg("slides_at") = std::map<std::string, ArrayLike>(),
            nb::arg("friction") = std::map<std::string, double>(),
            nb::arg("bending_stiffness") = nb::none(),
            nb::arg("support_stiffness") = std::map<int, ArrayLike>(),
            nb::arg("support_place") = std::map<int, ArrayLike>(), nb::arg("kind") = Names(),
            nb::arg("buckling_load") = nb::none(), nb::arg("sag_weight") = nb::none(),
            nb::arg("cable_ends") = Names(),
            R"(Checks every rule of a net.

Args:
    nodes: (n, 3) nominal form [m].
    supports: nodes on the frame.
    edges: (m, 2) pairs of nodes.
    axial_stiffness: EA (m,), or one number for all [N].
    unstressed_lengths: (m,) [m].
    adjustable: edges with a turnbuckle, by default those at supports.
    loads: (n, 3) external forces [N].
    name: of the net.
    node_ids: names of nodes (n,), for messages and files.
    edge_ids: names of edges (m,).
    tension_laws: piecewise linear laws of tension over strain.
    tension_law: which of them each edge has (m,), -1: none.
    groups: named lists of edges.
    mass: of a metre of edge (m,), or one number [kg/m].
    expansion: thermal strain by temperature (m,), or one number [1/K].
    breaking_load: (m,), or one number [N].
    thread: 'right' or 'left' of each turnbuckle, in the order of adjustable.
    runs: named lists of edges that are cut from one cable; by default edges that go straight on
        through a node.
    slides_at: nodes of runs where the cable can slide, by the name of the run.
    friction: coefficient of friction there, by the name of the run. By default it is not known:
        forms are those of 0, and identification assumes any up to 0.1.
    bending_stiffness: EI (m,), or one number, for tensions from frequencies [N m2].
    support_stiffness: of those supports that give way, by node: one number, three of the axes, or a
        matrix (3, 3) [N/m].
    support_place: where they stand without load, by node (3,) [m], by default their place in
        `nodes`; or 'balanced': such that they are in balance in the nominal form.
    kind: 'cable' or 'strut' of each edge, by default all cables. A strut carries compression, too.
    buckling_load: of struts (m,), infinite where not known and at cables, or one number for all
        struts [N].
    sag_weight: weight of a metre across the chord, which makes a cable sag between its nodes (m,),
        one number for all cables, or 'mass': of `mass` [N/m]. It adds no load.
    cable_ends: 'hinged', 'fixed' or 'unknown' of each edge, or of all, for tensions from frequencies.

Raises:
    NetError: naming the place, the value and the rule.
    ValueError, TypeError: for a wrong shape or dtype.)");
    refuse_other_arguments(net);
    net.def_static(
        "from_json", [](const std::string& text) { return parse_net(text, "net").net; },
        nb::arg("text"),
        "A net in taut's own JSON format.\n\nRaises:\n    InputError: at a line and column, or a "
        "JSON pointer.");
    net.def_static(
        "from_dict",
        [](const nb::dict& data) {
            const auto text = nb::cast<std::string>(of_package("taut.calls", "json_of")(data));
            return parse_net(text, "data").net;
        },
        nb::arg("data"),
        "A net as to_dict() gives it, with arrays in place of lists where you like: with loads, "
        "say, net.to_dict() | {'loads': loads}."
        "\n\nRaises:\n    InputError: at a JSON pointer.");
    net.def_static(
        "load", [](const std::filesystem::path& path) { return read_net(path).net; },
        nb::arg("path"),
        "Reads net.json.\n\nRaises:\n    InputError: naming file, place and rule.");
    net.def(
        "to_json", [](const CableNet& self) { return net_to_json(self); },
        "The net as net.json holds it, numbers to the last bit.");
    net.def(
        "save",
        [](const CableNet& self, const std::filesystem::path& path) {
            write_file(path, net_to_json(self));
        },
        nb::arg("path"), "Writes net.json, whole or not at all.");
    net.def(
        "to_dict", [](const CableNet& self) { return dict_of(net_to_json(self)); },
        "What net.json holds, as a dict.");
    net.def_prop_ro("name", &CableNet::name);
    net.def_prop_ro("nodes", view<&CableNet::nodes>(), "Nominal form (n, 3) [m].");
    net.def_prop_ro("edges", view<&CableNet::edges>(), "Both nodes of each edge (m, 2).");
    net.def_prop_ro("axial_stiffness", view<&CableNet::axial_stiffness>(), "EA (m,) [N].");
    net.def_prop_ro("unstressed_lengths", view<&CableNet::unstressed_lengths>(),
                    "l_0 of all edges (m,) [m].");
    net.def_prop_ro("loads", view<&CableNet::loads>(),
                    "External forces, self-weight included (n, 3) [N].");
    net.def_prop_ro(
        "supports", [](const CableNet& self) { return array_of(self.all_supports()); },
        "Nodes on the frame: rigid ones, then those with a support_stiffness.");
    net.def_prop_ro(
        "support_stiffness",
        by_node([](const ElasticSupport& one) { return array_of_columns(one.stiffness); }),
        "Of supports that give way, by node (3, 3) [N/m]. They are among the free nodes.");
    net.def_prop_ro(
        "support_couplings",
        [](const CableNet& self) {
            nb::dict result;
            for (const auto& [first, second, stiffness] : self.support_couplings()) {
                result[nb::make_tuple(self.elastic_supports()[first].node,
                                      self.elastic_supports()[second].node)] =
                    array_of_columns(Eigen::Matrix3d(stiffness.transpose()));
            }
            return result;
        },
        "Of pairs of supports on one frame, by their nodes: the force on the first by a shift of "
        "the second (3, 3) [N/m]. on_frame() sets them.");
    net.def_prop_ro("support_place",
                    by_node([](const ElasticSupport& one) { return array_of(one.place); }),
                    "Where they stand without load, by node (3,) [m].");
    net.def_prop_ro(
        "kind",
        [](const CableNet& self) {
            Names kinds;
            for (int e = 0; e < self.edge_count(); ++e) {
                kinds.emplace_back(self.is_strut(e) ? "strut" : "cable");
            }
            return kinds;
        },
        "'cable' or 'strut' of each edge.");
    net.def_prop_ro(
        "cable_ends",
        [](const CableNet& self) {
            Names ends;
            for (const CableEnds one : self.data().cable_ends) {
                ends.push_back(to_string(one));
            }
            return ends;
        },
        "'hinged', 'fixed' or 'unknown' of each edge, or empty.");
    net.def_prop_ro(
        "buckling_load", [](const CableNet& self) { return array_of(self.data().buckling_load); },
        "Of struts, infinite where not known (m,), or empty [N].");
    net.def_prop_ro(
        "sag_weight", [](const CableNet& self) { return array_of(self.data().sag_weight); },
        "Weight of a metre across the chord, which makes a cable sag (m,), or empty [N/m].");
    net.def_prop_ro("free_nodes", view<&CableNet::free_nodes>(), "Free nodes, ascending.");
    net.def_prop_ro("interior_edges", view<&CableNet::interior_edges>(),
                    "Edges of uncertain length, ascending.");
    net.def_prop_ro("adjustable_edges", view<&CableNet::adjustable_edges>(),
                    "Edges whose length is known and set, ascending.");
    net.def_prop_ro(
        "groups", [](const CableNet& self) { return self.data().groups; }, "Named lists of edges.");
    net.def_prop_ro("runs", &cable_runs,
                    "Lists of edges that are cut from one cable: as given, or found by going "
                    "straight on through nodes.");
    net.def("node_id", &CableNet::node_id, nb::arg("node"),
            "The node's name, or its index as text.");
    net.def("edge_id", &CableNet::edge_id, nb::arg("edge"),
            "The edge's name, or its index as text.");
    net.def_prop_ro("fingerprint", &CableNet::fingerprint,
                    "16 digits over all that makes the net behave as it does.");
    net.def(
        "on_frame",
        [](const CableNet& self, const ArrayLike& stiffness,
           const std::optional<ArrayLike>& supports) {
            return on_frame(self, {.supports = supports ? indices_argument(*supports, "supports")
                                                        : self.all_supports(),
                                   .stiffness = columns_argument(stiffness, "stiffness")});
        },
        nb::arg("stiffness"), nb::arg("supports") = nb::none(),
        R"(The net on a frame: its supports give way, and pass forces on to each other.

They stand where the frame balances the nominal form.

Args:
    stiffness: of the frame, condensed to its supports (3 k, 3 k): the force at x, y, z of each by a
        shift of each. Symmetric and positive definite [N/m].
    supports: its nodes (k,), by default all of `supports` of this net in their order: rigid ones,
        then those with springs, which are replaced.

Raises:
    ValueError: for a node that is no support or stands on a frame already, and a stiffness of
        another shape or that is not symmetric.
    NetError: where it is not positive definite.)");
    net.def(
        "with_lengths",
        [](const CableNet& self, const ArrayLike& unstressed_lengths) {
            CableNetData data = self.data();
            data.unstressed_lengths =
                vector_argument(unstressed_lengths, "unstressed_lengths", self.edge_count());
            return CableNet(std::move(data));
        },
        nb::arg("unstressed_lengths"), "The same net with other lengths (m,) [m].");
    net.def_static(
        "from_compas",
        [](const nb::args& args, const nb::kwargs& settings) {
            return of_package("taut.compas", "from_compas")(*args, **settings);
        },
        nb::sig("def from_compas(structure: object, *, name: str | None = None, select: str = '', "
                "axial_stiffness: float | None = None, young: float | None = None, diameter: float "
                "| None = None, diameter_attribute: str = '', force_unit: float | None = None, "
                "supports: Sequence[object] | None = None, boundary: bool = False, loads: str = "
                "'file', slides: str = 'none') -> CableNet"),
        R"(A net from a COMPAS 2 Mesh or Graph (Network), or from the path of a file of COMPAS 1 or 2. Its
unstressed lengths follow from the edges' forces or force densities and the stiffness of cables.

Args:
    select: key of the structure, where a file holds several.
    axial_stiffness: EA of edges without one of their own [N]; or young [Pa] with diameter [m], or
        the name of the edges' attribute that holds their diameter.
    force_unit: of the structure's forces [N]; 1000 where they are in kN.
    supports: keys of its supports, where its nodes have no mark.
    boundary: the nodes of a mesh's boundary are supports.
    loads: those of the structure ('file'), 'none', or those that 'balance' its forces.
    slides: cables that slide through their nodes: edges of one name but for the number at its end
        ('names'), or that go 'straight' on.

Raises:
    InputError: for what is missing or contradicts itself, at its place in the structure.
    ValueError: where it has neither forces nor loads.
    ImportError: without COMPAS 2.

Warns:
    UserWarning: of what is left out, and of what does not fit together.)");
    net.def_static(
        "from_jax_fdm",
        [](const nb::args& args, const nb::kwargs& settings) {
            return of_package("taut.compas", "from_jax_fdm")(*args, **settings);
        },
        nb::sig("def from_jax_fdm(structure: object, q: numpy.typing.ArrayLike, *, xyz_fixed: "
                "numpy.typing.ArrayLike, axial_stiffness: numpy.typing.ArrayLike, loads: "
                "numpy.typing.ArrayLike | None = None, name: str = 'jax-fdm') -> CableNet"),
        R"(A net from a structure of JAX FDM and its force densities.

Args:
    structure: EquilibriumStructure.
    q: force densities (m,) [N/m].
    xyz_fixed: places of its fixed nodes, in their order (f, 3) [m].
    axial_stiffness: EA (m,), or one number for all [N].
    loads: (n, 3) [N].)");
    net.def(
        "to_compas",
        [](nb::handle_t<CableNet> self, const nb::object& form, const nb::object& like) {
            return of_package("taut.compas", "to_compas")(self, form, like);
        },
        nb::arg("form") = nb::none(), nb::kw_only(), nb::arg("like") = nb::none(),
        nb::sig("def to_compas(self, form: numpy.typing.ArrayLike | None = None, *, like: object = "
                "None) -> object"),
        R"(A form (n, 3) in COMPAS 2, by default the nominal one [m]: with forces, force densities and
unstressed lengths.

Args:
    like: the Mesh or Graph that the net was made of. Then a copy of it, with its keys, faces and
        attributes, else a Graph with the net's numbers as keys. Edges that the net does not
        have keep theirs.

Raises:
    ValueError: where it lacks a node or an edge of the net.
    ImportError: without COMPAS 2.)");
    net.def(
        "to_dataframe",
        [](nb::handle_t<CableNet> self) { return of_package("taut.tables", "net_frame")(self); },
        nb::sig("def to_dataframe(self) -> object"), "Its edges as a pandas.DataFrame, SI units.");
    net.def("_repr_html_", [](nb::handle_t<CableNet> self) {
        return of_package("taut.notebook", "net_html")(self);
    });
    net.def(
        "__eq__",
        [](const CableNet& self, const CableNet& other) {
            return net_to_json(self) == net_to_json(other);
        },
        nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"));
    net.def("__hash__", [](const CableNet& self) {
        return static_cast<nb::ssize_t>(std::hash<std::string>()(self.fingerprint()));
    });
    net.def("__getstate__", [](const CableNet& self) { return net_to_json(self); });
    net.def("__setstate__", [](CableNet& self, const std::string& text) {
        new (&self) CableNet(parse_net(text, "net").net);
    });
    net.def("__repr__", [](const CableNet& self) {
        return fmt::format(
            "CableNet('{}': {} free nodes, {} supports, {} interior and {} adjustable edges)",
            self.name(), self.node_count() - std::ssize(self.all_supports()),
            self.all_supports().size(), self.interior_edge_count(), self.adjustable_edges().size());
    });
}

}  // namespace taut::python
