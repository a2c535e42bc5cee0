# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a net that is not the one drawn, and against scripts for Grasshopper that do not
run. Rhino cannot run here: plain classes stand in for what the scripts take of it."""

import runpy
import sys
from collections import namedtuple
from pathlib import Path
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
import taut
from taut.lines import net_from_lines

SCRIPTS = Path(__file__).parents[2] / "integrations" / "grasshopper"
MM = 1e-3  # the drawing's unit [m]

Point3d = namedtuple("Point3d", "X Y Z")
Line = namedtuple("Line", "From To")


def drawn(places):
    return [Point3d(*place) for place in (np.asarray(places) / MM).tolist()]


def lines_of(net):
    points = drawn(net.nodes)
    return [Line(points[s], points[t]) for s, t in net.edges]


@pytest.fixture
def drawing(net):
    """The net as it is drawn in millimetres: its lines, supports and tensions."""
    tensions = taut.tensions(net, net.unstressed_lengths, net.nodes)
    return {
        "lines": lines_of(net),
        "supports": drawn(net.nodes[net.supports]),
        "tension": tensions.tolist(),
    }


def test_lines_become_the_net_that_was_drawn(net, drawing):
    made = net_from_lines(axial_stiffness=net.axial_stiffness, scale=MM, **drawing)
    assert len(made.nodes) == len(net.nodes)
    assert (len(made.supports), len(made.edges)) == (len(net.supports), len(net.edges))
    assert made.unstressed_lengths == pytest.approx(net.unstressed_lengths, rel=1e-12)
    ends = [made.nodes[made.edges[:, k]] - net.nodes[net.edges[:, k]] for k in (0, 1)]
    assert np.abs(ends).max() < 1e-12, "edges are in the order of the lines"
    assert np.abs(taut.solve_equilibrium(made).form - made.nodes).max() < 1e-8


def test_a_polyline_is_an_edge_from_point_to_point():
    across = [(0, 0, 0), (1, 0, 0), (2, 0, 0)]
    along = [Point3d(1, -1, 0), Point3d(1, 0, 0.0002), Point3d(1, 1, 0)]
    corners = [(0, 0, 0), (2, 0, 0), (1, -1, 0), (1, 1, 0)]
    net = net_from_lines([across, along], corners, 1e5, force_density=1e3)
    assert net.edges.tolist() == [[0, 1], [1, 2], [3, 1], [1, 4]], "a node within the tolerance"
    assert net.unstressed_lengths == pytest.approx(1 / 1.01, rel=1e-3)


@pytest.mark.parametrize("shift", [0.0, 0.0005, -0.0005])
def test_ends_beside_the_border_of_a_cell_are_one_node(shift):
    near, off = 0.003 + shift - 1e-12, 0.003 + shift + 1e-12
    lines = [[(0, 0, 0), (near, near, near)], [(off, off, off), (1, 0, 0)]]
    assert len(net_from_lines(lines, [(0, 0, 0), (1, 0, 0)], 1e5, tension=10.0).nodes) == 3


def test_loads_may_balance_the_tensions():
    lines = [[(-1, 0, 1), (0, 0, 0)], [(1, 0, 1), (0, 0, 0)]]
    net = net_from_lines(lines, [(-1, 0, 1), (1, 0, 1)], 1e5, tension=[100.0], loads="balance")
    assert net.loads[1] == pytest.approx([0.0, 0.0, -200.0 / np.sqrt(2)], abs=1e-9)
    assert not net.loads[[0, 2]].any()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"lines": None}, "lines: got none"),
        ({"supports": [(5, 5, 5)]}, "supports: got at 0 a point where no line ends"),
        ({"tension": None}, "got 0 of them, expected one"),
        ({"force_density": 1.0}, "got 2 of them, expected one"),
        ({"tension": [1.0, 2.0, 3.0]}, "tension: got 3 numbers, expected one, or 2 of lines"),
        ({"tension": [1.0, -2.0]}, r"tension: got -2\.0 at line 1, expected 0 or more"),
        ({"axial_stiffness": "soft"}, "axial_stiffness: 'soft' is no force"),
        ({"scale": float("nan")}, "scale: got nan, expected a number above 0"),
        ({"tolerance": "1mm"}, "tolerance: got '1mm'"),
        ({"loads": "file"}, "loads: got 'file'"),
        ({"lines": [[(0, 0), (1, 0)]]}, "points: got other than three coordinates"),
    ],
)
def test_wrong_arguments_are_named(change, words):
    lines = [[(0, 0, 0), (1, 0, 0)], [(1, 0, 0), (2, 0, 0)]]
    arguments = {"lines": lines, "supports": [(0, 0, 0), (2, 0, 0)], "axial_stiffness": 1e5}
    with pytest.raises(ValueError, match=words):
        net_from_lines(**(arguments | {"tension": 10.0} | change))


def test_numbers_may_be_text_or_arrays():
    lines = [[(0, 0, 0), (1, 0, 0)], [(1, 0, 0), (2, 0, 0)]]
    supports = [(0, 0, 0), (2, 0, 0)]
    by_text = net_from_lines(lines, supports, "100kN", tension=["10N", 10.0])
    by_arrays = net_from_lines(lines, supports, np.array(1e5), tension=np.array(10.0))
    assert by_text == by_arrays


@pytest.fixture
def rhino(monkeypatch):
    """What the scripts take of Rhino, of a drawing in millimetres."""
    module = ModuleType("Rhino")
    module.RhinoMath = SimpleNamespace(UnitScale=lambda of, to: {("mm", "m"): MM}[of, to])
    module.RhinoDoc = SimpleNamespace(ActiveDoc=SimpleNamespace(ModelUnitSystem="mm"))
    module.UnitSystem = SimpleNamespace(Meters="m")
    module.Geometry = ModuleType("Rhino.Geometry")
    module.Geometry.Line, module.Geometry.Point3d = Line, Point3d
    monkeypatch.setitem(sys.modules, "Rhino", module)
    monkeypatch.setitem(sys.modules, "Rhino.Geometry", module.Geometry)


def run(script, **inputs):
    return SimpleNamespace(**runpy.run_path(str(SCRIPTS / script), inputs))


IDENTIFY = ("lines", "mesh", "supports", "EA", "tension", "loads", "measured", "noise", "uncertain")
PLAN = ("result", "stroke", "least", "most", "turn", "step", "crews", "thread")


@pytest.mark.usefixtures("rhino")
def test_the_components_go_from_a_drawing_to_turns(net, drawing, form):
    inputs = dict.fromkeys(IDENTIFY) | drawing
    inputs |= {"EA": net.axial_stiffness.tolist(), "noise": "0.5mm"}
    inputs |= {"measured": drawn(form[net.free_nodes])}
    found = run("identify.py", run=True, **inputs)
    assert found.verdict in ("passed", "doubtful")
    assert len(found.built) == len(found.lengths) == len(found.tensions) == len(net.edges)
    start = MM * np.array(found.built[0].From)
    assert start == pytest.approx(form[net.edges[0, 0]], abs=2e-3)
    known = np.isnan(found.stds)
    assert np.flatnonzero(known).tolist() == sorted(net.adjustable_edges)
    assert all(isinstance(one, str) for one in found.findings)

    planned = run(
        "plan.py", run=True, **dict.fromkeys(PLAN) | {"result": found.result, "stroke": "15mm"}
    )
    assert len(planned.turned) == len(planned.edges) == len(planned.strokes) > 0
    assert len(planned.turns) > len(planned.edges), "a line of names comes first"
    assert planned.feasible in (True, False)
    assert planned.summary[-1].startswith("Plan(")


@pytest.mark.usefixtures("rhino")
def test_a_component_takes_a_mesh_of_compas(net):
    pytest.importorskip("compas")
    graph = net.to_compas()
    inputs = dict.fromkeys(IDENTIFY) | {"mesh": graph, "noise": "0.5mm"}
    inputs |= {"measured": drawn(net.nodes[net.free_nodes])}
    found = run("identify.py", run=True, **inputs)
    assert np.nanmax(np.abs(found.deviations)) < 1e-3


@pytest.mark.usefixtures("rhino")
@pytest.mark.parametrize(("script", "inputs"), [("identify.py", IDENTIFY), ("plan.py", PLAN)])
def test_a_component_rests_until_it_is_to_run_and_says_where_taut_is_missing(
    script, inputs, monkeypatch
):
    head = (SCRIPTS / script).read_text(encoding="utf-8").split('"""')[1]
    assert all(f"{name} (" in head or f"{name}, " in head for name in inputs)
    assert "has not been run in Rhino" in head
    rested = run(script, run=False, **dict.fromkeys(inputs))
    assert rested.turns is None if script == "plan.py" else rested.result is None
    monkeypatch.setitem(sys.modules, "taut", None)
    with pytest.raises(ImportError, match=r"has no taut .*docs/grasshopper\.md"):
        run(script, run=False, **dict.fromkeys(inputs))
