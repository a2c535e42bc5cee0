# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a net from COMPAS or JAX FDM that is not in equilibrium where it was there."""

import json
import re
import sys
from types import SimpleNamespace

import numpy as np
import pytest
import taut
from taut import notebook

compas = pytest.importorskip("compas")

from compas.datastructures import Graph, Mesh

pytestmark = pytest.mark.filterwarnings("ignore:.*left out")


def grid():
    """A mesh whose edges all have one force density, its boundary fixed."""
    mesh = Mesh.from_meshgrid(dx=6.0, nx=6)
    mesh.update_default_edge_attributes(q=2.0e3)
    for key in mesh.vertices_on_boundary():
        mesh.vertex_attribute(key, "is_anchor", True)
    for key in mesh.vertices():
        x, y, _ = mesh.vertex_coordinates(key)
        mesh.vertex_attribute(key, "z", 0.05 * (x - 3.0) * (y - 3.0))
    return mesh


def test_a_mesh_becomes_a_net_and_goes_back():
    net = taut.CableNet.from_compas(grid(), axial_stiffness=200e3)
    assert len(net.nodes) == 45, "an edge between supports is none, and a corner has no other"
    form = taut.solve_equilibrium(net).form
    assert np.abs(form - net.nodes).max() < 1e-6, "the form it was found in is its own"
    graph = net.to_compas(form)
    assert graph.number_of_nodes() == 45
    assert graph.number_of_edges() == len(net.edges)
    back = taut.CableNet.from_compas(graph)
    assert np.abs(back.unstressed_lengths - net.unstressed_lengths).max() < 1e-9


def test_attributes_of_a_mesh_say_what_gives_way_sags_and_slides():
    mesh = grid()
    spring = np.diag([2e5, 2e5, 4e5]).tolist()
    mesh.vertex_attribute(3, "support_stiffness", spring)
    for edge in zip(range(21, 27), range(22, 28), strict=True):
        mesh.edge_attributes(edge, ["run", "sag_weight"], ["middle", 5.0])
    mesh.vertex_attribute(24, "slides", True)
    mesh.vertex_attribute(25, "slides", ["middle"])
    net = taut.CableNet.from_compas(mesh, axial_stiffness=200e3)
    node = [net.node_id(k) for k in range(len(net.nodes))].index("3")
    assert net.support_stiffness[node].tolist() == spring
    form = taut.solve_equilibrium(net).form
    assert np.abs(form - net.nodes).max() < 1e-6, "springs stand so that the form is in balance"
    assert (np.array(net.to_dict()["sag_weight"]) > 0.0).sum() == 6
    (run,) = net.to_dict()["runs"]
    assert [net.node_id(k) for k in sorted(run["slides_at"])] == ["24", "25"]

    back = net.to_compas(form, like=mesh)
    assert back.vertex_attribute(3, "support_stiffness") == spring
    assert back.vertex_attribute(24, "slides") == ["middle"]
    again = taut.CableNet.from_compas(back)
    assert again.support_place[node] == pytest.approx(net.support_place[node], abs=1e-12)
    assert again.unstressed_lengths == pytest.approx(net.unstressed_lengths, abs=1e-9)
    assert again.to_dict()["runs"][0]["slides_at"] == run["slides_at"]


@pytest.mark.parametrize("is_mesh", [True, False])
def test_a_structure_comes_back_as_it_was_with_the_form(is_mesh):
    mesh = grid()
    mesh.vertex_attribute(8, "panel", "B4")
    structure = mesh
    if not is_mesh:
        places = {key: mesh.vertex_coordinates(key) for key in mesh.vertices()}
        structure = Graph.from_nodes_and_edges(places, list(mesh.edges()))
        for key in mesh.vertices_on_boundary():
            structure.node_attribute(key, "is_anchor", True)
        structure.update_default_edge_attributes(q=2.0e3)
        structure.node_attribute(8, "panel", "B4")
    left_out = (
        "left out: 24 edges between two supports, 4 nodes without edges (nodes 0, 6, 42, 48; "
        "edges (0, 7), (0, 1), (1, 2), (2, 3), (3, 4) and 19 more)"
    )
    with pytest.warns(UserWarning, match=re.escape(left_out)):
        net = taut.CableNet.from_compas(structure, axial_stiffness=200e3)
    form = np.array(net.nodes)
    form[net.free_nodes] += 0.01
    back = net.to_compas(form, like=structure)
    assert type(back) is type(structure)
    keys = list(back.vertices() if is_mesh else back.nodes())
    assert keys == list(structure.vertices() if is_mesh else structure.nodes())
    attribute = back.vertex_attribute if is_mesh else back.node_attribute
    place = back.vertex_attributes if is_mesh else back.node_attributes
    assert attribute(8, "panel") == "B4"
    names = [net.node_id(node) for node in range(len(net.nodes))]
    assert place(8, "xyz") == pytest.approx(form[names.index("8")], abs=1e-15)
    edge = net.edges[0]
    start, end = (int(names[node]) for node in edge)
    assert back.edge_attribute((start, end), "l0") == pytest.approx(net.unstressed_lengths[0])
    with pytest.raises(ValueError, match="without the net's node"):
        net.to_compas(like=Mesh.from_meshgrid(dx=1.0, nx=2))
    attribute = structure.vertex_attribute if is_mesh else structure.node_attribute
    for key in keys:
        attribute(key, "name", f"N{key}")
    named = taut.CableNet.from_compas(structure, axial_stiffness=200e3)
    assert named.node_id(names.index("8")) == "N8"
    assert list(named.to_compas(like=structure).edges()) == list(structure.edges())


def test_a_mesh_without_forces_is_refused():
    mesh = Mesh.from_meshgrid(dx=6.0, nx=6)
    with pytest.raises(ValueError, match=r"marks no supports .* take the boundary"):
        taut.CableNet.from_compas(mesh, axial_stiffness=200e3)
    with pytest.raises(ValueError, match="structure: Mesh has neither forces f nor force dens"):
        taut.CableNet.from_compas(mesh, axial_stiffness=200e3, boundary=True)


@pytest.mark.parametrize(
    ("settings", "error", "words"),
    [
        ({}, ValueError, "stiffness"),
        ({"structure": 7}, TypeError, "structure: got int"),
        (
            {"axial_stiffness": "200kN"},
            TypeError,
            "from_compas: axial_stiffness: got str, expected",
        ),
        ({"axial_stiffness": 1e5, "supports": 3}, TypeError, "supports: got int"),
        ({"stiffness": 1e5}, TypeError, r"from_compas\(\) got an unexpected .*'stiffness'"),
        ({"axial_stiffness": 1e5, "loads": "some"}, ValueError, "loads: got 'some'"),
        ({"select": "net"}, ValueError, "select"),
    ],
)
def test_wrong_arguments_are_named(settings, error, words):
    with pytest.raises(error, match=words):
        taut.CableNet.from_compas(**({"structure": grid()} | settings))


def test_an_old_compas_is_refused(monkeypatch):
    monkeypatch.setattr(compas, "__version__", "1.17.5")
    with pytest.raises(ImportError, match=r"COMPAS 2, this is 1\.17\.5"):
        taut.CableNet.from_compas(object())


def test_a_file_of_compas(tmp_path):
    compas.json_dump(grid(), tmp_path / "grid.json")
    net = taut.CableNet.from_compas(tmp_path / "grid.json", axial_stiffness=200e3)
    same = taut.CableNet.from_compas(grid(), axial_stiffness=200e3)
    assert np.array_equal(net.unstressed_lengths, same.unstressed_lengths)
    with pytest.raises(taut.InputError, match=r"absent\.json"):
        taut.CableNet.from_compas(tmp_path / "absent.json")


class Structure:
    """What an EquilibriumStructure of JAX FDM holds. The keys of its nodes have gaps."""

    nodes = np.array([7, 10, 20, 30, 40])
    edges = np.array([(7, 10), (7, 20), (7, 30), (7, 40)])
    indices_fixed = np.array([1, 2, 3, 4])


def test_a_structure_of_jax_fdm():
    fixed = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0.5], [0, -1, 0.5]], dtype=float)
    q = np.array([1e3, 1e3, 2e3, 2e3])
    net = taut.CableNet.from_jax_fdm(Structure(), q, xyz_fixed=fixed, axial_stiffness=100e3)
    assert net.node_id(4) == "40"
    form = taut.solve_equilibrium(net).form
    assert form[0] == pytest.approx((q[:, None] * fixed).sum(axis=0) / q.sum(), abs=1e-9)
    tension = taut.tensions(net, net.unstressed_lengths, form)
    assert tension == pytest.approx(q * taut.edge_lengths(net, form), rel=1e-9)
    for structure, q_wrong, fixed_wrong, error, words in [
        (Structure(), q[:2], fixed, ValueError, "q: got the shape"),
        (Structure(), q * [1, 1, -0.5, 1], fixed, ValueError, r"q: got -1000\.0 at edge 2"),
        (Structure(), q, fixed[:2], ValueError, "xyz_fixed"),
        (7, q, fixed, TypeError, "structure: got int"),
    ]:
        with pytest.raises(error, match=words):
            taut.CableNet.from_jax_fdm(
                structure, q_wrong, xyz_fixed=fixed_wrong, axial_stiffness=1e5
            )


def test_a_notebook_shows_net_identification_and_plan(net, found):
    drawing = net._repr_html_()
    assert drawing.count("M") >= len(net.edges)
    for result in (found, taut.plan(found)):
        shown = result._repr_html_()
        if taut.has_report_viewer():
            assert shown.startswith("<iframe srcdoc=")
            loads = r"(?:src|href)=(?:&quot;|[\"'])?https?:|url\((?:&quot;|[\"'])?https?:"
            assert not re.search(loads, shown)
            assert len(shown) > 500_000
        else:
            assert shown.startswith("<pre>")


@pytest.mark.skipif(not taut.has_report_viewer(), reason="built without the report's viewer")
@pytest.mark.parametrize("cells", ["abc", (1, 2, 3)], ids=["named", "numbered"])
def test_a_notebook_has_the_page_of_reports_once(cells, found, monkeypatch):
    monkeypatch.setattr(notebook, "_holder", ("", ""))

    def shown_in(cell, result):
        metadata = {"cellId": cell} if isinstance(cell, str) else {}
        kernel = SimpleNamespace(get_parent=lambda: {"metadata": metadata}) if cell else None
        shell = SimpleNamespace(kernel=kernel, execution_count=cell)
        monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
        return result._repr_mimebundle_()["text/html"]

    results = (found, taut.plan(found), found)
    first, second, third = map(shown_in, cells, results)
    digest = re.search(r'data-taut-page="(\w+)"', first)[1]
    for shown in (second, third):
        assert len(shown) < 0.1 * len(first)
        assert f'iframe[data-taut-page="{digest}"]' in shown
        (frame,) = re.findall(r'<iframe [^>]*id="(taut-\w+)"', shown)
        assert f"""querySelectorAll('[id="{frame}"]')""" in shown
    assert len(shown_in(cells[0], found)) > 500_000, "the cell with the page was run once more"
    assert len(shown_in(cells[1], found)) < 0.1 * len(first)
    assert len(shown_in(None, found)) > 500_000, "outside of notebooks"
    assert found._repr_html_() == shown_in(None, found), "for a file"
    (data,) = re.findall(r"slice\(0, begin\) \+ (.*) \+ page", third)
    assert json.loads(json.loads(data)) == json.loads(found.to_json())


def test_a_report_and_a_drawing(found, tmp_path):
    assert taut.form_to_obj(found.net).count("\nl ") == len(found.net.edges)
    with pytest.raises(taut.InputError, match="absent"):
        taut.write_report(tmp_path / "absent.json", tmp_path / "report.html")
