# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a form-found net of COMPAS FoFin or JAX FDM that is another one in taut, or that
comes back without the numbers that these programs show.

Stand-ins with the attributes of the real classes always run. The real ones (compas_fofin 0.15,
jax_fdm 0.14) run where they are installed.
"""

import importlib

import numpy as np
import pytest
import taut

pytest.importorskip("compas")

from compas.datastructures import Graph, Mesh

pytestmark = pytest.mark.filterwarnings("ignore:.*left out")

LOADS = {"px": 0.0, "py": 0.0, "pz": 0.0}
FD_NODES = {"x": 0.0, "y": 0.0, "z": 0.0, **LOADS, "rx": 0.0, "ry": 0.0, "rz": 0.0}
FD_EDGES = {"q": 0.0, "length": 0.0, "force": 0.0, **LOADS}


class CableMesh(Mesh):
    """Of compas_fofin 0.15.3."""

    def __init__(self, **settings):
        super().__init__(**settings)
        self.attributes.update(density=1)
        self.default_vertex_attributes.update(
            {**LOADS, "is_support": False, "constraint": None, "thickness": 0, "_residual": None}
        )
        self.default_edge_attributes.update(q=1.0, f=0.0, l=0.0, l0=0.0, E=0.0, radius=0.0, _f=0.0)


class FDNetwork(Graph):
    """Of jax_fdm 0.14.1."""

    def __init__(self, **settings):
        super().__init__(**settings)
        self.update_default_edge_attributes(FD_EDGES)
        self.update_default_node_attributes({**FD_NODES, "is_support": False})


class FDMesh(Mesh):
    """Of jax_fdm 0.14.1."""

    def __init__(self, **settings):
        super().__init__(**settings)
        self.update_default_edge_attributes(FD_EDGES)
        self.update_default_vertex_attributes({**FD_NODES, "is_support": False})


STAND_INS = {one.__name__: one for one in (CableMesh, FDNetwork, FDMesh)}
REAL = [("compas_fofin", "CableMesh"), ("jax_fdm", "FDNetwork"), ("jax_fdm", "FDMesh")]


@pytest.fixture(
    params=[*STAND_INS, *REAL], ids=lambda one: one if one in STAND_INS else ".".join(one)
)
def structure_type(request):
    if request.param in STAND_INS:
        return STAND_INS[request.param]
    package, name = request.param
    pytest.importorskip(package, reason=f"{package} is not installed: its stand-in runs alone")
    try:
        return getattr(importlib.import_module(f"{package}.datastructures"), name)
    except ImportError as error:
        pytest.skip(f"{package} is there, but not what it needs: {error}")


def form_found(structure_type):
    """A structure in equilibrium, with a load at its middle; its node attributes; its boundary."""
    grid = Mesh.from_meshgrid(dx=6.0, nx=6)
    if issubclass(structure_type, Mesh):
        structure = structure_type.from_vertices_and_faces(*grid.to_vertices_and_faces())
        at = structure.vertex_attributes
    else:
        places = {key: grid.vertex_coordinates(key) for key in grid.vertices()}
        structure = structure_type.from_nodes_and_edges(places, list(grid.edges()))
        at = structure.node_attributes
    boundary = set(grid.vertices_on_boundary())
    for key in boundary:
        x, y = at(key, "xy")
        at(key, ["z", "is_support"], [0.05 * (x - 3.0) * (y - 3.0), True])
    for edge in structure.edges():
        structure.edge_attribute(edge, "q", 2.0e3 + 10.0 * sum(edge))
    at(24, ["pz"], [-150.0])
    keys = list(grid.vertices())
    edges = list(structure.edges())
    form = taut.form_from_force_densities(
        np.array([at(key, "xyz") for key in keys]),
        [keys.index(key) for key in boundary],
        [(keys.index(s), keys.index(t)) for s, t in edges],
        structure.edges_attribute("q"),
        np.array([at(key, ("px", "py", "pz")) for key in keys], dtype=float),
    )
    for node, key in enumerate(keys):
        at(key, "xyz", form[node].tolist())
    return structure, at, boundary


def test_a_form_found_structure_is_understood_and_filled(structure_type):
    structure, at, boundary = form_found(structure_type)
    at(0, ["panel"], ["A1"])
    net = taut.CableNet.from_compas(structure, axial_stiffness=200e3)
    assert (len(net.supports), net.loads.sum()) == (20, -150.0), "corners hold no free node"
    form = taut.solve_equilibrium(net).form
    assert np.abs(form - net.nodes).max() < 1e-8, "its own form is in equilibrium"

    back = net.to_compas(form, like=structure)
    assert type(back) is structure_type
    back_at = back.vertex_attributes if isinstance(back, Mesh) else back.node_attributes
    assert back_at(0, ["panel"]) == ["A1"]
    tensions = taut.tensions(net, net.unstressed_lengths, form)
    lengths = taut.edge_lengths(net, form)
    names = set(structure.default_edge_attributes)
    for e, (s, t) in enumerate(net.edges):
        edge = int(net.node_id(int(s))), int(net.node_id(int(t)))
        edge = edge if edge in set(back.edges()) else edge[::-1]
        for name in {"f", "force", "_f"} & (names | {"f"}):
            assert back.edge_attribute(edge, name) == pytest.approx(tensions[e]), name
        for name in {"l", "length"} & (names | {"l"}):
            assert back.edge_attribute(edge, name) == pytest.approx(lengths[e]), name
        assert back.edge_attribute(edge, "l0") == pytest.approx(net.unstressed_lengths[e])

    by_axis = "rx" in (
        back.default_vertex_attributes if isinstance(back, Mesh) else back.default_node_attributes
    )
    residuals = {
        key: np.array(list(back_at(key, ("rx", "ry", "rz") if by_axis else ["_residual"])[:]))
        for key in [*boundary, 24]
    }
    assert np.abs(residuals[24]).max() < 1e-5, "a free node is in equilibrium"
    held = sum(residuals[key].reshape(3) for key in boundary)
    assert held == pytest.approx([0.0, 0.0, -150.0], abs=1e-4), "supports hold the load"

    again = taut.CableNet.from_compas(back)
    assert again.unstressed_lengths == pytest.approx(net.unstressed_lengths, abs=1e-9)


def numbers_of(structure):
    """Of each node, and of each edge, as JAX FDM keeps them."""
    is_mesh = isinstance(structure, Mesh)
    at = structure.vertex_attributes if is_mesh else structure.node_attributes
    keys = structure.vertices() if is_mesh else structure.nodes()
    edges = structure.edges()
    return (
        np.array([at(key, ("x", "y", "z", "rx", "ry", "rz")) for key in keys]),
        np.array([structure.edge_attributes(edge, ("q", "force", "length")) for edge in edges]),
    )


@pytest.mark.parametrize("name", ["FDNetwork", "FDMesh"])
def test_forces_and_residuals_are_those_of_jax_fdm(name):
    pytest.importorskip("jax_fdm", reason="jax_fdm is not installed")
    from jax_fdm import datastructures
    from jax_fdm.equilibrium import fdm

    structure, _, _ = form_found(getattr(datastructures, name))
    solved = fdm(structure)
    net = taut.CableNet.from_compas(solved, axial_stiffness=200e3)
    (nodes, edges), (nodes_there, edges_there) = map(
        numbers_of, (net.to_compas(like=structure), solved)
    )
    assert nodes == pytest.approx(nodes_there, abs=1e-7)
    in_net = edges[:, 1] != 0.0
    assert in_net.sum() == len(net.edges), "an edge between two supports is none"
    assert edges[in_net] == pytest.approx(edges_there[in_net], abs=1e-7)


def test_a_cable_mesh_has_its_stiffness_by_modulus_and_radius():
    mesh, _, _ = form_found(CableMesh)
    mesh.update_default_edge_attributes(E=210.0, radius=0.003)
    net = taut.CableNet.from_compas(mesh)
    assert net.axial_stiffness == pytest.approx(210e9 * np.pi * 0.003**2)


def test_a_cable_mesh_without_thickness_has_no_self_weight_to_leave_out():
    mesh, _, _ = form_found(CableMesh)
    with pytest.warns(UserWarning, match="left out") as caught:
        taut.CableNet.from_compas(mesh, axial_stiffness=200e3)
    assert "self-weight" not in str(caught[0].message)
    mesh.update_default_vertex_attributes(thickness=0.05)
    with pytest.warns(UserWarning, match=r"left out.*self-weight \(density 1\)"):
        taut.CableNet.from_compas(mesh, axial_stiffness=200e3)
