#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes plan_reference.json: a small net that is built wrong, and the strokes by which SciPy brings
it nearest to its design within limits of tension, and to its design and to target tensions, for
tests/adjustment.

    python3 tests/data/make_plan_reference.py

Made with SciPy 1.17.1. Equilibrium by Newton's method on the energy, the strokes by SLSQP with
derivatives by differences of exact equilibria: no code or formula is shared with the library.
"""

import json
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

ROWS, COLUMNS = 3, 4
SPACING = 0.5
STIFFNESS = 100e3
DENSITY = 2e3  # of the force-found design [N/m]
LOWER, UPPER, STROKE = 800.0, 1150.0, 10e-3
FORM_TOLERANCE = 2e-3  # [m]
TENSIONS = {0: (1000.0, 50.0), 9: (900.0, 30.0), 14: (1100.0, 80.0), 21: (850.0, 40.0)}  # and tolerances [N]


def make_net():
    """A saddle of ROWS x COLUMNS free nodes, supports around it: nodes, edges, is_free."""
    grid = {}
    nodes, is_free = [], []
    for i in range(-1, ROWS + 1):
        for j in range(-1, COLUMNS + 1):
            inside = 0 <= i < ROWS and 0 <= j < COLUMNS
            if not inside and (i in (-1, ROWS)) and (j in (-1, COLUMNS)):
                continue
            grid[i, j] = len(nodes)
            x, y = i / (ROWS - 1) - 0.5, j / (COLUMNS - 1) - 0.5
            nodes.append([SPACING * i, SPACING * j, 0.6 * x * y])
            is_free.append(inside)
    edges = [[grid[a], grid[b]] for a in grid for b in ((a[0] + 1, a[1]), (a[0], a[1] + 1))
             if b in grid and (is_free[grid[a]] or is_free[grid[b]])]
    return np.array(nodes), np.array(edges), np.array(is_free)


NODES, EDGES, FREE = make_net()
S, T = EDGES.T


def form_found():
    """Coordinates with equal force densities."""
    incidence = np.zeros((len(EDGES), len(NODES)))
    incidence[np.arange(len(EDGES)), S] = 1
    incidence[np.arange(len(EDGES)), T] = -1
    laplacian = incidence.T @ incidence
    nodes = NODES.copy()
    nodes[FREE] = np.linalg.solve(laplacian[np.ix_(FREE, FREE)],
                                  -laplacian[np.ix_(FREE, ~FREE)] @ nodes[~FREE])
    return nodes


def equilibrium(lengths, start):
    nodes = start.copy()
    for _ in range(200):
        vector = nodes[S] - nodes[T]
        length = np.linalg.norm(vector, axis=1)
        tension = STIFFNESS * np.maximum(0, length / lengths - 1)
        force = np.zeros_like(nodes)
        pull = (tension / length)[:, None] * vector
        np.add.at(force, S, pull)
        np.add.at(force, T, -pull)
        residual = force[FREE].ravel()
        if np.abs(residual).max() < 1e-9 * tension.mean():
            return nodes, tension
        unit = vector / length[:, None]
        axial = np.where(tension > 0, STIFFNESS / lengths, 0)
        blocks = (axial - tension / length)[:, None, None] * unit[:, :, None] * unit[:, None, :]
        blocks += (tension / length)[:, None, None] * np.eye(3)
        matrix = np.zeros((len(nodes), 3, len(nodes), 3))
        for s, t, block in zip(S, T, blocks):
            matrix[s, :, s] += block
            matrix[t, :, t] += block
            matrix[s, :, t] -= block
            matrix[t, :, s] -= block
        matrix = matrix[FREE][:, :, FREE].reshape(residual.size, residual.size)
        nodes[FREE] -= np.linalg.solve(matrix, residual).reshape(-1, 3)
    raise RuntimeError("no equilibrium")


def main():
    design = form_found()
    spans = np.linalg.norm(design[S] - design[T], axis=1)
    nominal = spans / (1 + DENSITY * spans / STIFFNESS)
    random = np.random.default_rng(5)
    adjustable = np.flatnonzero(~(FREE[S] & FREE[T]))
    lengths = nominal + np.where(FREE[S] & FREE[T], random.uniform(-5e-3, 5e-3, len(EDGES)), 0)
    built, _ = equilibrium(lengths, design)

    def at(strokes):
        changed = lengths.copy()
        changed[adjustable] += 1e-3 * strokes
        return equilibrium(changed, built)

    def cost(strokes):
        return 1e6 * np.sum((at(strokes)[0] - design)[FREE] ** 2) / FREE.sum()

    def cost_with_tensions(strokes):
        tension = at(strokes)[1]
        off = [(tension[edge] - target) / tolerance for edge, (target, tolerance) in TENSIONS.items()]
        return cost(strokes) + 1e6 * FORM_TOLERANCE**2 * np.mean(np.square(off))

    def margins(strokes):
        tension = at(strokes)[1] / 1e3
        return np.concatenate([tension - LOWER / 1e3, UPPER / 1e3 - tension])

    def best_of(function):
        best = None
        for seed in range(4):
            start = np.random.default_rng(seed).uniform(-2, 2, len(adjustable))
            found = minimize(function, start, method="SLSQP", bounds=[(-1e3 * STROKE, 1e3 * STROKE)] * len(adjustable),
                             constraints={"type": "ineq", "fun": margins},
                             options={"ftol": 1e-12, "maxiter": 500})
            if found.success and (best is None or found.fun < best.fun):
                best = found
        return best

    best = best_of(cost)
    tension = at(best.x)[1]
    with_tensions = best_of(cost_with_tensions)
    reached = at(with_tensions.x)[1]
    reference = {
        "nodes": design.tolist(), "supports": np.flatnonzero(~FREE).tolist(), "edges": EDGES.tolist(),
        "axial_stiffness": STIFFNESS, "nominal": nominal.tolist(), "built": lengths.tolist(),
        "adjustable": adjustable.tolist(), "lower": LOWER, "upper": UPPER, "stroke": STROKE,
        "mean_square_as_built": cost(np.zeros(len(adjustable))) * 1e-6,
        "mean_square": best.fun * 1e-6, "strokes": (1e-3 * best.x).tolist(),
        "least_tension": tension.min(), "most_tension": tension.max(),
        "with_tensions": {
            "form_tolerance": FORM_TOLERANCE, "cost": with_tensions.fun * 1e-6,
            "targets": [{"edge": edge, "tension": target, "tolerance": tolerance, "reached": reached[edge]}
                        for edge, (target, tolerance) in TENSIONS.items()],
        },
    }
    path = Path(__file__).with_name("plan_reference.json")
    path.write_text(json.dumps(reference, indent=1) + "\n")
    print(f"{path.name}: {len(adjustable)} strokes, mean square {reference['mean_square_as_built']:.4e} -> "
          f"{best.fun * 1e-6:.6e} m2, tension {tension.min():.1f} to {tension.max():.1f} N")


if __name__ == "__main__":
    main()
