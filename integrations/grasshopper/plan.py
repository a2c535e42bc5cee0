#! python 3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Which turnbuckle to turn how far: for a Python 3 Script component of Rhino 8.

This script has not been run in Rhino. Its test has stand-ins for what it takes of Rhino:
tests/python/test_grasshopper.py. docs/grasshopper.md says how to set up the component.

Inputs (access, type hint). Lengths and forces are numbers in m and N, or text, "15mm":
    run (item, bool): compute.
    result (item, none): of the component of identify.py.
    stroke (item, none): longest stroke of each turnbuckle, either way.
    least, most (item, none): limits of every tension.
    turn (item, none): change of length by one turn.
    step (item, float): smallest part of a turn that a crew can do.
    crews (item, int): number that work at the same time.
    thread (item, str): right or left.

Outputs:
    turned: lines of the edges to turn, in the planned form.
    edges: their indices, those of the lines.
    strokes: change of the unstressed length of each, positive lengthens [m].
    turns: the list for the crews, a line of CSV each.
    feasible: whether all limits are kept, with the confidence required.
    summary: form and limits before and after, and warnings, as text.
"""
# ruff: noqa: F821 - Grasshopper defines the inputs.

import Rhino
from Rhino.Geometry import Line, Point3d

try:
    import taut
except ImportError as error:
    raise ImportError(
        f"Rhino's Python has no taut ({error}): docs/grasshopper.md of taut says how to install it"
    ) from error

turned = edges = strokes = turns = feasible = summary = None
if run:
    given = {"stroke": stroke, "turn": turn, "step": step, "crews": crews, "thread": thread}
    if least is not None or most is not None:
        given["tension"] = (least, most)
    plan = taut.plan(result, **{name: one for name, one in given.items() if one is not None})

    metres = Rhino.RhinoMath.UnitScale(
        Rhino.RhinoDoc.ActiveDoc.ModelUnitSystem, Rhino.UnitSystem.Meters
    )
    form = (plan.form / metres).tolist()
    ends = plan.net.edges[plan.edges].tolist()
    turned = [Line(Point3d(*form[s]), Point3d(*form[t])) for s, t in ends]
    edges = plan.edges.tolist()
    strokes = plan.strokes.tolist()
    turns = plan.to_csv().splitlines()
    feasible = plan.is_feasible
    summary = [*plan.warnings, str(plan)]
