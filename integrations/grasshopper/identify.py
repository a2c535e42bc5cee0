#! python 3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Lengths and tensions of a surveyed cable net: for a Python 3 Script component of Rhino 8.

This script has not been run in Rhino. Its test has stand-ins for what it takes of Rhino:
tests/python/test_grasshopper.py. docs/grasshopper.md says how to set up the component.

Inputs (access, type hint):
    run (item, bool): compute.
    lines (list, Line): cables in the nominal form, in the unit of the drawing; or mesh.
    mesh (item, none): a COMPAS mesh or network with force densities, in m and N.
    supports (list, Point3d): where lines end at the frame.
    EA (list, float): axial stiffness of each line, or one number for all [N].
    tension (list, float): of each line in the nominal form, or one number for all [N].
    loads (item, str): none, or balance: those that balance the tensions.
    measured (list, Point3d): surveyed nodes, in the unit of the drawing.
    noise (item, str): standard deviation of the survey, "0.5mm".
    uncertain (list, str): what else is uncertain, "stiffness:3%".

Outputs, of edges in the order of the lines:
    result: for the component of plan.py.
    built: lines in the estimated form.
    lengths: unstressed, as estimated [m].
    deviations, stds: true minus nominal length, its standard deviation [m]; NaN at adjustable
        edges, whose lengths are known.
    tensions: [N].
    verdict: passed, doubtful or failed.
    findings: what the survey and the checks show, as text.
"""
# ruff: noqa: F821 - Grasshopper defines the inputs.

import Rhino
from Rhino.Geometry import Line, Point3d

try:
    import taut
    from taut.lines import coordinates, net_from_lines
    from taut.tables import identification_columns
except ImportError as error:
    raise ImportError(
        f"Rhino's Python has no taut ({error}): docs/grasshopper.md of taut says how to install it"
    ) from error

result = built = lengths = deviations = stds = tensions = verdict = findings = None
if run:
    metres = Rhino.RhinoMath.UnitScale(
        Rhino.RhinoDoc.ActiveDoc.ModelUnitSystem, Rhino.UnitSystem.Meters
    )
    if mesh is None:
        net = net_from_lines(
            lines, supports, EA, tension=tension, loads=loads or "none", scale=metres
        )
    else:
        net = taut.CableNet.from_compas(mesh, axial_stiffness=EA[0] if EA else None)
    survey = taut.read_survey(net, metres * coordinates(measured), noise=noise)
    result = taut.identify(net, survey, uncertain=uncertain or [])

    columns = identification_columns(result)
    lengths = result.built.unstressed_lengths.tolist()
    deviations = columns["length_deviation"].tolist()
    stds = columns["std"].tolist()
    tensions = result.tension.tolist()
    form = (result.form / metres).tolist()
    built = [Line(Point3d(*form[s]), Point3d(*form[t])) for s, t in net.edges.tolist()]
    verdict = result.trust
    findings = [*survey.warnings, *survey.notes]
    findings += [f"{one['severity']}: {one['reason']} {one['next']}" for one in result.findings]
