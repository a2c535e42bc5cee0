#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes sliding_reference.json: forms of nets whose runs slide without friction, for tests/statics.

    build/venv/test/bin/python tests/data/make_sliding_reference.py

SciPy minimises the energy of the form, without a line of taut: a stretch of cable that slides is one spring
over the whole way through its nodes, EA / (2 L) max(0, way - L)^2, so that no length ever passes anywhere.
"""

import json
from pathlib import Path

import numpy as np
from scipy.optimize import minimize


def stretches(net):
    """Edges that share one length: those of a run between nodes where it does not slide."""
    left = set(range(len(net["edges"])))
    for run in net["runs"]:
        stretch = [run["edges"][0]]
        for before, after in zip(run["edges"], run["edges"][1:]):
            (node,) = set(net["edges"][before]) & set(net["edges"][after])
            if node in run["slides_at"]:
                stretch.append(after)
            else:
                yield stretch
                stretch = [after]
        yield stretch
        left -= set(run["edges"])
    yield from ([edge] for edge in sorted(left))


def solve(net):
    nodes, edges = np.array(net["nodes"], float), np.array(net["edges"])
    lengths, stiffness = np.array(net["unstressed_lengths"]), np.array(net["axial_stiffness"])
    loads = np.array(net["loads"], float)
    free = np.setdiff1d(np.arange(len(nodes)), net["supports"])
    groups = list(stretches(net))

    def energy(x):
        form = nodes.copy()
        form[free] = x.reshape(-1, 3)
        spans = form[edges[:, 0]] - form[edges[:, 1]]
        ways = np.linalg.norm(spans, axis=1)
        total = -np.sum(loads * form)
        forces = -loads.copy()
        for group in groups:
            length = lengths[group].sum()
            over = max(0.0, ways[group].sum() - length)
            total += stiffness[group[0]] / (2 * length) * over**2
            for edge in group:
                force = stiffness[edge] / length * over * spans[edge] / ways[edge]
                forces[edges[edge, 0]] += force
                forces[edges[edge, 1]] -= force
        return total, forces[free].ravel()

    def hessian(x, step=1e-7):
        columns = [energy(x + one)[1] - energy(x - one)[1] for one in step * np.eye(len(x))]
        return np.array(columns) / (2 * step)

    found = minimize(energy, nodes[free].ravel(), jac=True, hess=hessian, method="trust-exact").x
    for _ in range(20):  # to rounding errors
        found -= np.linalg.solve(hessian(found), energy(found)[1])
    left = np.abs(energy(found)[1]).max()
    assert left < 1e-6, f"{net['name']}: {left} N out of balance"
    form = nodes.copy()
    form[free] = found.reshape(-1, 3)
    ways = np.linalg.norm(form[edges[:, 0]] - form[edges[:, 1]], axis=1)
    tensions = np.zeros(len(edges))
    for group in groups:
        length = lengths[group].sum()
        tensions[group] = stiffness[group[0]] / length * max(0.0, ways[group].sum() - length)
    return net | {"form": form.tolist(), "tensions": tensions.tolist()}


def ridge(name, slack):
    """A cable through four clamps, each held down by two stays; it slides at all but the second."""
    nodes = [[x, 0.0, z] for x, z in [(0, 3.0), (2, 2.2), (4.5, 1.8), (6, 1.9), (8, 2.4), (10, 3.2)]]
    edges = [[i, i + 1] for i in range(5)]
    for i in range(1, 5):
        for y in (-3.0, 3.5):
            edges.append([i, len(nodes)])
            nodes.append([nodes[i][0] + 0.3 * i - 0.5, y, 0.1 * i])
    spans = [float(np.linalg.norm(np.subtract(nodes[s], nodes[t]))) for s, t in edges]
    strains = [2e-3] * 5 + [1e-3] * 8
    if slack:
        strains[:5] = [-4e-3] * 5
    loads = np.zeros((len(nodes), 3))
    loads[1:5] = [[300, 0, -400], [0, 50, -900], [0, 0, -200], [-100, 0, -600]]
    return {
        "name": name,
        "nodes": nodes,
        "supports": [0, *range(5, len(nodes))],
        "edges": edges,
        "axial_stiffness": [4e6] * 5 + [1e6] * 8,
        "unstressed_lengths": [span / (1 + strain) for span, strain in zip(spans, strains)],
        "loads": loads.tolist(),
        "runs": [{"edges": [0, 1, 2, 3, 4], "slides_at": [1, 3, 4]}],
    }


if __name__ == "__main__":
    nets = [solve(ridge("ridge", slack=False)), solve(ridge("slack ridge", slack=True))]
    text = json.dumps({"nets": nets}, indent=1)
    Path(__file__).with_name("sliding_reference.json").write_text(text + "\n")
