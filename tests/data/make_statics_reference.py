#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes statics_reference.json: equilibrium forms of small nets found by SciPy, for tests/statics.

    build/venv/test/bin/python tests/data/make_statics_reference.py

Made with SciPy 1.17.1. The energy is written down once more here, without a line
of taut. SciPy minimises it by a trust region method, then finds the root of the forces by Powell's
hybrid method; the form counts when no force at a node exceeds 1e-12 of the largest tension, and it is
stable. With struts the energy has other minima; the start decides.
"""

import json
import re
from pathlib import Path

import numpy as np
import scipy
from scipy.integrate import quad
from scipy.optimize import brentq, minimize, root


class Net:
    """Nodes (n x 3), supports, edges (m x 2), EA and l_0 (m), loads (n x 3); springs: a list of a
    free node, its stiffness (3 x 3) and its place without load (3); struts: edges that carry
    compression, too; sags: weights across the chord (m), 0 of a straight edge; frame: k free nodes,
    their stiffness (3k x 3k) and their places without load (k x 3)."""

    def __init__(
        self,
        name,
        nodes,
        supports,
        edges,
        axial_stiffness,
        lengths,
        loads,
        springs=(),
        struts=(),
        sags=None,
        frame=((), np.zeros((0, 0)), np.zeros((0, 3))),
    ):
        self.name = name
        self.nodes = np.array(nodes, float)
        self.supports = sorted(supports)
        self.edges = np.array(edges)
        self.stiffness = np.array(axial_stiffness, float)
        self.lengths = np.array(lengths, float)
        self.loads = np.array(loads, float)
        self.springs = [(node, np.array(k, float), np.array(at, float)) for node, k, at in springs]
        self.free = [i for i in range(len(nodes)) if i not in supports]
        self.is_strut = np.isin(np.arange(len(edges)), struts)
        self.sags = np.zeros(len(edges)) if sags is None else np.array(sags, float)

        self.frame = tuple(np.array(part, kind) for part, kind in zip(frame, (int, float, float)))

    def form(self, x):
        form = self.nodes.copy()
        form[self.free] = x.reshape(-1, 3)
        return form

    def sagging_tension(self, edge, strain):
        """By bisection: the tension at which the arc of the parabola is as long as the cable."""
        weight = self.sags[edge] * self.lengths[edge]
        stiffness = self.stiffness[edge]
        most = stiffness * max(0.0, strain) + stiffness ** (1 / 3) * weight ** (2 / 3) + weight

        def arc_too_long(tension):
            return strain + (weight / tension) ** 2 / 24.0 - tension / stiffness

        least = 1e-3 * weight
        return brentq(arc_too_long, least, 10.0 * most, xtol=1e-300, rtol=1e-15)

    def edges_at(self, x):
        """Vectors, lengths and tensions of all edges."""
        form = self.form(x)
        vectors = form[self.edges[:, 0]] - form[self.edges[:, 1]]
        lengths = np.linalg.norm(vectors, axis=1)
        strain = lengths / self.lengths - 1.0
        strain = np.where(self.is_strut, strain, np.maximum(0.0, strain))
        tensions = self.stiffness * strain
        for edge in np.flatnonzero(self.sags):
            tensions[edge] = self.sagging_tension(edge, lengths[edge] / self.lengths[edge] - 1.0)
        return vectors, lengths, tensions

    def edge_energies(self, lengths, tensions):
        stretch = tensions * self.lengths / self.stiffness
        energies = self.stiffness / (2.0 * self.lengths) * stretch**2
        for edge in np.flatnonzero(self.sags):
            strain = lengths[edge] / self.lengths[edge] - 1.0
            stored, _ = quad(lambda s, e=edge: self.sagging_tension(e, s), 0.0, strain, epsrel=1e-13)
            energies[edge] = stored * self.lengths[edge]
        return energies

    def axial(self, lengths, tensions):
        """dT/dl: that of a sagging cable by the derivative of its tension's equation."""
        flexibility = 1.0 / self.stiffness
        for edge in np.flatnonzero(self.sags):
            weight = self.sags[edge] * self.lengths[edge]
            flexibility[edge] += weight**2 / (12.0 * tensions[edge] ** 3)
        return 1.0 / (flexibility * self.lengths)

    def energy(self, x):
        _, lengths, tensions = self.edges_at(x)
        work = np.sum(self.loads[self.free] * self.form(x)[self.free])
        shifts = [(self.form(x)[node] - place, k) for node, k, place in self.springs]
        of_springs = sum(0.5 * shift @ k @ shift for shift, k in shifts)
        nodes, stiffness, places = self.frame
        shift = (self.form(x)[nodes] - places).ravel()
        of_frame = 0.5 * shift @ stiffness @ shift
        return np.sum(self.edge_energies(lengths, tensions)) + of_springs + of_frame - work

    def forces(self, x):
        vectors, lengths, tensions = self.edges_at(x)
        pull = (tensions / lengths)[:, None] * vectors
        forces = -self.loads.copy()
        np.add.at(forces, self.edges[:, 0], pull)
        np.add.at(forces, self.edges[:, 1], -pull)
        for node, k, place in self.springs:
            forces[node] += k @ (self.form(x)[node] - place)
        nodes, stiffness, places = self.frame
        forces[nodes] += (stiffness @ (self.form(x)[nodes] - places).ravel()).reshape(-1, 3)
        return forces[self.free].ravel()

    def hessian(self, x):
        vectors, lengths, tensions = self.edges_at(x)
        n = len(self.nodes)
        hessian = np.zeros((n, 3, n, 3))
        for (s, t), vector, length, tension, axial in zip(
            self.edges, vectors, lengths, tensions, self.axial(lengths, tensions)
        ):
            if tension != 0.0:
                along = np.outer(vector, vector) / length**2
                block = axial * along + tension / length * (np.eye(3) - along)
                for i, j, sign in ((s, s, 1), (t, t, 1), (s, t, -1), (t, s, -1)):
                    hessian[i, :, j, :] += sign * block
        for node, k, _ in self.springs:
            hessian[node, :, node, :] += k
        nodes, stiffness, _ = self.frame
        hessian[np.ix_(nodes, range(3), nodes, range(3))] += stiffness.reshape(len(nodes), 3, len(nodes), 3)
        size = 3 * len(self.free)
        return hessian[self.free][:, :, self.free].reshape(size, size)

    def solve(self):
        x = minimize(
            self.energy,
            self.nodes[self.free].ravel(),
            jac=self.forces,
            hess=self.hessian,
            method="trust-exact",
            options={"gtol": 1e-6, "maxiter": 10000},
        ).x
        x = root(self.forces, x, jac=self.hessian, method="hybr", options={"xtol": 1e-15}).x
        _, _, tensions = self.edges_at(x)
        worst = np.linalg.norm(self.forces(x).reshape(-1, 3), axis=1).max()
        assert worst < 1e-12 * tensions.max(), f"{self.name}: {worst} N of {tensions.max()} N"
        slack = np.flatnonzero((tensions == 0.0) & ~self.is_strut)
        assert np.linalg.eigvalsh(self.hessian(x)).min() > 0.0, f"{self.name}: not stable"
        print(f"{self.name}: {len(self.free)} free nodes, slack edges {slack.tolist()}")
        return {
            "name": self.name,
            "nodes": self.nodes.tolist(),
            "supports": self.supports,
            "edges": self.edges.tolist(),
            "axial_stiffness": self.stiffness.tolist(),
            "unstressed_lengths": self.lengths.tolist(),
            "loads": self.loads.tolist(),
            "springs": [
                {"node": node, "stiffness": k.tolist(), "place": place.tolist()}
                for node, k, place in self.springs
            ],
            "frame": {
                "nodes": self.frame[0].tolist(),
                "stiffness": self.frame[1].tolist(),
                "places": self.frame[2].tolist(),
            },
            "struts": np.flatnonzero(self.is_strut).tolist(),
            "sags": self.sags.tolist() if self.sags.any() else [],
            "form": self.form(x).tolist(),
            "tensions": tensions.tolist(),
            "slack_edges": slack.tolist(),
            "energy": self.energy(x),
        }


def distances(nodes, edges):
    nodes = np.array(nodes, float)
    return np.array([np.linalg.norm(nodes[s] - nodes[t]) for s, t in edges])


def grid(random):
    """3 x 3 free nodes between 12 supports, with unlike stiffnesses, loads and two loose edges."""
    index = {}
    for i in range(5):
        for j in range(5):
            if (i in (0, 4)) + (j in (0, 4)) < 2:
                index[i, j] = len(index)
    nodes = [[0.5 * i, 0.5 * j, 0.1 * (i - 2) * (j - 2)] for i, j in index]
    supports = [node for (i, j), node in index.items() if i in (0, 4) or j in (0, 4)]
    edges = [
        (node, index[other])
        for (i, j), node in index.items()
        for other in ((i + 1, j), (i, j + 1))
        if other in index and not (node in supports and index[other] in supports)
    ]
    strain = random.uniform(0.0, 0.04, len(edges))
    strain[[7, 12]] = -0.3
    stiffness = 10.0 ** random.uniform(4.0, 6.0, len(edges))
    loads = random.normal(0.0, 200.0, (len(nodes), 3))
    lengths = distances(nodes, edges) / (1.0 + strain)
    return Net("grid", nodes, supports, edges, stiffness.round(), lengths.round(4), loads.round())


def chain():
    """Six edges of 1 m over a span of 5 m, all slack at first, under unlike weights."""
    nodes = [[5.0 / 6.0 * i, 0.0, 0.1 * i] for i in range(7)]
    edges = [(i, i + 1) for i in range(6)]
    loads = [[0.0, 10.0 * i, -500.0 - 100.0 * i] for i in range(7)]
    return Net("chain", nodes, [0, 6], edges, [100e3] * 6, [1.0] * 6, loads)


def tripod():
    """A ring of three nodes on three supports, prestressed, without loads; one edge of it slack."""
    angles = np.radians([90.0, 210.0, 330.0])
    ring = [[np.cos(a), np.sin(a), 0.3 * k] for k, a in enumerate(angles)]
    outer = [[3.0 * np.cos(a), 3.0 * np.sin(a), 0.0] for a in angles]
    middle = [[0.1, 0.0, 0.5]]
    nodes = np.round(ring + outer + middle, 6).tolist()
    edges = [(0, 3), (1, 4), (5, 2), (0, 1), (1, 2), (2, 0), (6, 0), (6, 1), (6, 2)]
    strain = [0.12, 0.13, 0.125, 0.01, 0.04, -0.4, 0.02, 0.05, 0.01]
    lengths = distances(nodes, edges) / (1.0 + np.array(strain))
    loads = np.zeros((7, 3))
    stiffness = [200e3, 200e3, 100e3, 50e3, 100e3, 100e3, 20e3, 20e3, 40e3]
    return Net("tripod", nodes, [3, 4, 5], edges, stiffness, lengths.round(6), loads)


def on_springs(random):
    """The grid with five of its supports on springs that pull across their axes, too."""
    net = grid(np.random.default_rng(1))
    springs = []
    for node in net.supports[::3] + net.supports[1:2]:
        root = random.uniform(-1.0, 1.0, (3, 3))
        stiffness = (10.0 ** random.uniform(4.0, 6.0) * (root @ root.T + np.eye(3))).round()
        place = net.nodes[node] + random.uniform(-0.05, 0.05, 3).round(3)
        springs.append((node, stiffness, place))
    rigid = [node for node in net.supports if node not in [spring[0] for spring in springs]]
    return Net("springs", net.nodes, rigid, net.edges, net.stiffness, net.lengths, net.loads, springs)


def on_frame(random):
    """The grid with four of its supports on one frame."""
    net = grid(np.random.default_rng(1))
    nodes = net.supports[:4]
    root = random.uniform(-1.0, 1.0, (12, 12))
    stiffness = (5e4 * (root @ root.T + 0.3 * np.eye(12))).round()
    places = net.nodes[nodes] + random.uniform(-0.02, 0.02, (4, 3)).round(3)
    frame = (nodes, stiffness, places)
    return Net("frame", net.nodes, net.supports[4:], net.edges, net.stiffness, net.lengths, net.loads, frame=frame)


def simplex():
    """Three struts and three cables up to a ring of three, loaded; one foot is on a spring."""
    angles = np.radians([0.0, 120.0, 240.0, 30.0, 150.0, 270.0])
    nodes = [[1.18 * np.cos(a), 1.18 * np.sin(a), 1.95 * (k > 2)] for k, a in enumerate(angles)]
    nodes = np.round(nodes, 4)
    edges = [(0, 4), (1, 5), (2, 3), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5), (1, 2)]
    forces = np.array([-6000.0] * 3 + [2358.0] * 3 + [4086.0] * 3 + [2358.0])
    stiffness = np.array([25.65e6] * 3 + [3.609e6] * 3 + [3.631e6] * 3 + [3.609e6])
    lengths = distances(nodes, edges) / (1.0 + forces / stiffness)
    loads = [[0, 0, 0]] * 3 + [[20.0, 0.0, -100.0], [0.0, 15.0, -50.0], [0.0, 0.0, -300.0]]
    spring = (1, np.diag([5e5, 8e5, 2e6]), nodes[1] + [0.004, -0.002, 0.001])
    return Net("simplex", nodes, [0, 2], edges, stiffness, lengths.round(6), loads, [spring], [0, 1, 2])


def mast():
    """A mast of two struts on top of each other, held by four guys at either level, in the wind."""
    nodes = [[0, 0, 4.0], [0, 0, 8.0], [0, 0, 0]]
    nodes += [[5 * x, 5 * y, 0.2 * x] for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    edges = [(2, 0), (0, 1)] + [(level, 3 + k) for level in (0, 1) for k in range(4)]
    strain = np.array([-2e-4, -1e-4] + [2e-3] * 4 + [1.5e-3] * 4)
    stiffness = [80e6, 60e6] + [3e6] * 4 + [2e6] * 4
    lengths = distances(nodes, edges) / (1.0 + strain)
    loads = np.zeros((7, 3))
    loads[:2] = [[900.0, 300.0, -500.0], [700.0, -200.0, -400.0]]
    return Net("mast", nodes, [2, 3, 4, 5, 6], edges, stiffness, lengths.round(6), loads, (), [0, 1])


def sagging(random):
    """The grid with cables that sag, two of them 5 % longer than the distance of their nodes."""
    net = grid(np.random.default_rng(1))
    net.name = "sagging"
    loose = net.lengths > 1.1 * distances(net.nodes, net.edges)
    net.lengths[loose] = (1.05 * distances(net.nodes, net.edges)[loose]).round(4)
    net.sags = random.uniform(0.0, 200.0, len(net.edges)).round(1)
    net.sags[[0, 5]] = 0.0
    return net


class Catenaries(Net):
    """Cables that hang as elastic catenaries, each solved from the formulas of H. M. Irvine (1981) for
    the force at its ends: no parabola, no chord. Weights (m) [N/m] act along the unstressed cable."""

    def end_forces(self, edge, vector):
        """Of a cable from its lower end up to vector: the pulls at the lower and upper end."""
        weight, length = self.weights[edge], self.lengths[edge]
        stiffness = self.stiffness[edge]
        across = np.hypot(vector[0], vector[1])

        def misfit(force):
            h, v = force  # at the upper end
            low = v - weight * length
            x = h * length / stiffness + h / weight * (np.arcsinh(v / h) - np.arcsinh(low / h))
            z = (v + low) * length / (2.0 * stiffness)
            z += (np.hypot(h, v) - np.hypot(h, low)) / weight
            return [x - across, z - vector[2]]

        chord = np.linalg.norm(vector)
        pull = self.sagging_tension(edge, chord / length - 1.0)
        start = [pull * across / chord, pull * vector[2] / chord + 0.5 * weight * length]
        h, v = root(misfit, start, method="hybr", options={"xtol": 1e-14}).x
        assert np.abs(misfit([h, v])).max() < 1e-12
        along = np.array([vector[0], vector[1], 0.0]) / across
        return h * along + [0, 0, v - weight * length], h * along + [0, 0, v]

    def forces(self, x):
        form = self.form(x)
        forces = -self.loads.copy()
        for edge, (s, t) in enumerate(self.edges):
            low, high = (s, t) if form[s, 2] <= form[t, 2] else (t, s)
            at_low, at_high = self.end_forces(edge, form[high] - form[low])
            forces[low] -= at_low
            forces[high] += at_high
        return forces[self.free].ravel()

    def solve(self):
        x = root(self.forces, self.nodes[self.free].ravel(), method="hybr", options={"xtol": 1e-14}).x
        worst = np.abs(self.forces(x)).max()
        assert worst < 1e-6, f"{self.name}: {worst} N"
        form = self.form(x)
        middles = []  # the tension along the chord: half of the pulls at both ends, less the weight
        for edge, (s, t) in enumerate(self.edges):
            low, high = (s, t) if form[s, 2] <= form[t, 2] else (t, s)
            at_low, at_high = self.end_forces(edge, form[high] - form[low])
            chord = (form[high] - form[low]) / np.linalg.norm(form[high] - form[low])
            middles.append(0.5 * (at_low + at_high) @ chord)
        print(f"{self.name}: {worst:.1g} N out of balance")
        return {
            "name": self.name,
            "nodes": form.tolist(),
            "supports": self.supports,
            "edges": self.edges.tolist(),
            "axial_stiffness": self.stiffness.tolist(),
            "unstressed_lengths": self.lengths.tolist(),
            "loads": self.loads.tolist(),
            "weights": self.weights.tolist(),
            "form": form.tolist(),
            "tensions": middles,
        }


def catenaries():
    """Two nodes between six supports: cables of 15 to 25 m, 8 kg/m, which sag by 1 to 3 % of their
    chords."""
    nodes = [[-9.0, 0.5, 6.0], [9.0, -0.5, 6.4]]
    nodes += [[-25, -9, 10.0], [-26, 10, 9.0], [25, -10, 9.5], [26, 9, 10.5], [-9, 16, 2.0], [9, -17, 1.5]]
    edges = [(0, 1), (0, 2), (0, 3), (1, 4), (1, 5), (0, 6), (1, 7)]
    tensions = np.array([30e3, 17e3, 18e3, 17e3, 18e3, 9e3, 9e3])
    stiffness = np.array([60e6] * 5 + [40e6] * 2)
    weights = np.array([80.0] * 5 + [60.0] * 2)
    chords = distances(nodes, edges)
    lengths = chords * (1.0 + (weights * chords / tensions) ** 2 / 24.0) / (1.0 + tensions / stiffness)
    net = Catenaries("catenaries", nodes, range(2, 8), edges, stiffness, lengths.round(4), np.zeros((8, 3)))
    net.weights = weights
    net.sags = weights  # where each search of an edge's forces starts
    return net


def main():
    nets = [
        grid(np.random.default_rng(1)),
        chain(),
        tripod(),
        on_springs(np.random.default_rng(2)),
        simplex(),
        mast(),
        sagging(np.random.default_rng(3)),
        catenaries(),
        on_frame(np.random.default_rng(4)),
    ]
    reference = {
        "SPDX-FileCopyrightText": "2026 The taut authors",
        "SPDX-License-Identifier": "MIT",
        "made_by": "build/venv/test/bin/python tests/data/make_statics_reference.py",
        "scipy": scipy.__version__,
        "nets": [net.solve() for net in nets],
    }
    path = Path(__file__).with_name("statics_reference.json")
    # Lists of numbers on one line each.
    text = re.sub(r"\[[^][{}]*\]", lambda m: " ".join(m[0].split()), json.dumps(reference, indent=1))
    path.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
