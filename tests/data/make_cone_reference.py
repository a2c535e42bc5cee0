# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes cone_reference.json: the paper's SOCP of small nets solved through CVXPY, for tests/statics.

    python3 -m venv venv && venv/bin/pip install cvxpy==1.9.3 ecos
    venv/bin/python tests/data/make_cone_reference.py

The program is written down once more here, as the paper has it (eq. SOCP, with v and the large cone)
and with the loads, in newtons and metres, without a line of taut. ECOS and SCS solve it, each
without the other; the nets are those of statics_reference.json, whose forms SciPy found by a third
way.
"""

import json
import re
from pathlib import Path

import cvxpy
import numpy as np

FOLDER = Path(__file__).parent
SOLVERS = {
    "ECOS": {"abstol": 1e-9, "reltol": 1e-9, "feastol": 1e-9, "max_iters": 200},
    "SCS": {"eps_abs": 1e-9, "eps_rel": 1e-9, "max_iters": 500_000},
}


def solve(net, solver):
    nodes = np.array(net["nodes"])
    edges = np.array(net["edges"])
    lengths = np.array(net["unstressed_lengths"])
    loads = np.array(net["loads"])
    stiffness = np.array(net["axial_stiffness"]) / lengths
    free = [i for i in range(len(nodes)) if i not in net["supports"]]
    # Forces in mean tensions, so that both solvers get numbers of order one.
    force = np.mean([tension for tension in net["tensions"] if tension > 0.0])

    r = cvxpy.Variable(nodes.shape)
    w = cvxpy.Variable(len(edges))
    v = cvxpy.Variable()
    stretch = cvxpy.norm(r[edges[:, 0]] - r[edges[:, 1]], axis=1) - lengths
    constraints = [
        cvxpy.multiply(np.sqrt(stiffness / force), stretch) <= w,
        0 <= w,
        cvxpy.norm(cvxpy.hstack([2 * w, 1 - v])) <= 1 + v,
        r[net["supports"]] == nodes[net["supports"]],
    ]
    work = cvxpy.sum(cvxpy.multiply(loads[free] / force, r[free]))
    problem = cvxpy.Problem(cvxpy.Minimize(v / 2 - work), constraints)
    problem.solve(solver=solver, **SOLVERS[solver])
    assert problem.status == cvxpy.OPTIMAL, f"{net['name']}, {solver}: {problem.status}"
    distance = np.abs(r.value - np.array(net["form"])).max()
    print(f"{net['name']}, {solver}: value {force * problem.value:.9g} J, "
          f"{1e6 * distance:.2g} um from SciPy's form")
    return {"form": r.value.tolist(), "value": force * problem.value}


def main():
    nets = json.loads((FOLDER / "statics_reference.json").read_text())["nets"]
    reference = {
        "SPDX-FileCopyrightText": "2026 The taut authors",
        "SPDX-License-Identifier": "MIT",
        "made_by": "tests/data/make_cone_reference.py",
        "cvxpy": cvxpy.__version__,
        "nets": [
            {"name": net["name"], **{solver: solve(net, solver) for solver in SOLVERS}}
            for net in nets
        ],
    }
    # Lists of numbers on one line each.
    text = re.sub(r"\[[^][{}]*\]", lambda m: " ".join(m[0].split()), json.dumps(reference, indent=1))
    (FOLDER / "cone_reference.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
