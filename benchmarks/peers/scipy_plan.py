# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The strokes that bring a net nearest to its design within limits of tension, by SciPy's SLSQP; prints JSON.

Usage: /usr/bin/python3 benchmarks/peers/scipy_plan.py NET BUILT LEAST MOST

NET is the design, BUILT the net as identified (`taut export result.json --to net`), both in taut's format; tensions in N.
Equilibrium is Newton's method with scipy.sparse; derivatives are those of equilibrium, by one sparse factorisation. Limits
that are far from being reached are left out, as one would to keep SLSQP quick.
"""

import json
import sys
import time

import numpy as np
import scipy
from scipy.optimize import minimize
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

STROKE = 0.015
NORMAL, TANGENTIAL = 1.0, 0.1


class Net:
    def __init__(self, design, built):
        self.design, self.start = (np.array(net["nodes"], float) for net in (design, built))
        self.lengths = np.array(built["unstressed_lengths"], float)
        self.edges = np.array(built["edges"])
        self.stiffness = np.broadcast_to(np.array(built["axial_stiffness"], float), len(self.edges))
        self.loads = np.array(built.get("loads") or np.zeros_like(self.start), float)
        self.free = np.setdiff1d(np.arange(len(self.start)), built["supports"])
        self.row = np.full(len(self.start), -1)
        self.row[self.free] = np.arange(len(self.free))
        at_support = np.isin(self.edges, built["supports"]).any(axis=1)
        self.adjustable = np.array(design.get("adjustable", np.flatnonzero(at_support)))
        self.normals = self.normals_of(self.design)

    def normals_of(self, form):
        """By the smallest axis of each node's neighbours."""
        result = np.zeros_like(form)
        for node in self.free:
            mine = self.edges[(self.edges == node).any(axis=1)]
            around = form[np.unique(mine)] - form[np.unique(mine)].mean(axis=0)
            result[node] = np.linalg.svd(around)[2][2]
        return result

    def state(self, lengths, form):
        vector = form[self.edges[:, 0]] - form[self.edges[:, 1]]
        span = np.linalg.norm(vector, axis=1)
        unit = vector / span[:, None]
        tension = self.stiffness * np.maximum(0, span / lengths - 1)
        axial = np.where(tension > 0, self.stiffness / lengths, 0)
        blocks = (axial - tension / span)[:, None, None] * unit[:, :, None] * unit[:, None, :]
        blocks += (tension / span)[:, None, None] * np.eye(3)
        rows, columns, values = [], [], []
        for sign, a, b in ((1, 0, 0), (1, 1, 1), (-1, 0, 1), (-1, 1, 0)):
            s, t = self.row[self.edges[:, a]], self.row[self.edges[:, b]]
            both = (s >= 0) & (t >= 0)
            for i in range(3):
                for j in range(3):
                    rows.append(3 * s[both] + i)
                    columns.append(3 * t[both] + j)
                    values.append(sign * blocks[both, i, j])
        size = 3 * len(self.free)
        matrix = coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (size, size)).tocsc()
        force = -self.loads.copy()
        np.add.at(force, self.edges[:, 0], tension[:, None] * unit)
        np.add.at(force, self.edges[:, 1], -tension[:, None] * unit)
        return force[self.free].ravel(), splu(matrix), unit, span, tension, axial

    def solve(self, strokes, form):
        lengths = self.lengths.copy()
        lengths[self.adjustable] += strokes
        form = form.copy()
        for _ in range(50):
            force, factor, unit, span, tension, axial = self.state(lengths, form)
            if np.abs(force).max() < 1e-9 * tension.mean():
                break
            form[self.free] -= factor.solve(force).reshape(-1, 3)
        else:
            raise RuntimeError("no equilibrium")
        by_length = -self.stiffness * span / lengths**2 * (tension > 0)
        right = np.zeros((3 * len(self.free), len(self.adjustable)))
        for k, e in enumerate(self.adjustable):
            for node, sign in zip(self.edges[e], (1, -1)):
                if self.row[node] >= 0:
                    right[3 * self.row[node]:3 * self.row[node] + 3, k] += sign * by_length[e] * unit[e]
        moved = np.zeros((len(form), 3, len(self.adjustable)))
        moved[self.free] = -factor.solve(right).reshape(len(self.free), 3, -1)
        change = moved[self.edges[:, 0]] - moved[self.edges[:, 1]]
        tension_rates = axial[:, None] * np.einsum("ei,eik->ek", unit, change)
        tension_rates[self.adjustable, np.arange(len(self.adjustable))] += by_length[self.adjustable]
        return form, tension, moved, tension_rates


def main():
    design, built = (json.load(open(name)) for name in sys.argv[1:3])
    least, most = map(float, sys.argv[3:5])
    net = Net(design, built)
    normal = net.normals[net.free]
    start = time.perf_counter()
    last = {"x": None, "form": net.start}

    def at(x):
        if last["x"] is None or not np.array_equal(x, last["x"]):
            form, tension, moved, rates = net.solve(1e-3 * x, last["form"])
            last.update(x=x.copy(), form=form, tension=tension, moved=moved[net.free], rates=rates)
        return last

    def cost(x):
        state = at(x)
        off = 1e3 * (state["form"] - net.design)[net.free]
        along = np.einsum("ni,ni->n", normal, off)
        value = TANGENTIAL * np.sum(off**2) + (NORMAL - TANGENTIAL) * np.sum(along**2)
        weighted = TANGENTIAL * off + (NORMAL - TANGENTIAL) * along[:, None] * normal
        return value / len(off), 2 * np.einsum("ni,nik->k", weighted, state["moved"]) / len(off)

    # Edges that may come near a limit, by twice what the strokes could do to first order at most.
    tension, rates = at(np.zeros(len(net.adjustable)))["tension"], last["rates"]
    reach = 0.004 * np.abs(rates).sum(axis=1)
    near = np.flatnonzero((tension - reach < least) | (tension + reach > most))
    limits = {
        "type": "ineq",
        "fun": lambda x: 1e-3 * np.concatenate([at(x)["tension"][near] - least, most - at(x)["tension"][near]]),
        "jac": lambda x: 1e-6 * np.concatenate([at(x)["rates"][near], -at(x)["rates"][near]]),
    }
    found = minimize(cost, np.zeros(len(net.adjustable)), jac=True, method="SLSQP", constraints=limits,
                     bounds=[(-1e3 * STROKE, 1e3 * STROKE)] * len(net.adjustable), options={"maxiter": 300, "ftol": 1e-6})
    state = at(found.x)
    along = np.einsum("ni,ni->n", normal, (state["form"] - net.design)[net.free])
    print(json.dumps({
        "scipy": scipy.__version__, "seconds": time.perf_counter() - start, "iterations": int(found.nit),
        "success": bool(found.success), "weighted_rms": 1e-3 * float(np.sqrt(found.fun)),
        "normal_rmse": float(np.sqrt(np.mean(along**2))), "least": float(state["tension"].min()),
        "most": float(state["tension"].max())}))


if __name__ == "__main__":
    main()
