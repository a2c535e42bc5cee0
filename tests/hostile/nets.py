# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Random nets, from the ordinary to the absurd, and an independent judge of their forms."""

from __future__ import annotations

import json
import random
from itertools import pairwise

import numpy as np


def _grid(rng: random.Random, across: int, along: int) -> tuple[np.ndarray, list, list]:
    """Nodes of a grid over a hyperbolic paraboloid, its edges, and its boundary."""
    x, y = np.meshgrid(np.arange(across), np.arange(along), indexing="ij")
    z = rng.uniform(0, 0.4) * (x - across / 2) * (y - along / 2) / max(across, along)
    nodes = np.column_stack([x.ravel(), y.ravel(), z.ravel()]).astype(float)
    at = np.arange(across * along).reshape(across, along)
    edges = [(a, b) for row in at for a, b in pairwise(row)]
    edges += [(a, b) for column in at.T for a, b in pairwise(column)]
    boundary = sorted({*at[0], *at[-1], *at[:, 0], *at[:, -1]})
    edges = [e for e in edges if not (e[0] in boundary and e[1] in boundary)]
    used = {n for e in edges for n in e}
    keep = sorted(used)
    place = {n: i for i, n in enumerate(keep)}
    return (
        nodes[keep],
        [(place[a], place[b]) for a, b in edges],
        [place[n] for n in boundary if n in used],
    )


def _star(rng: random.Random, arms: int) -> tuple[np.ndarray, list, list]:
    """One node that hangs on many supports."""
    angles = np.linspace(0, 2 * np.pi, arms, endpoint=False)
    ring = np.column_stack(
        [np.cos(angles), np.sin(angles), [rng.uniform(-0.3, 0.3) for _ in angles]]
    )
    return (
        np.vstack([[0.1, 0.05, 0.02], ring]),
        [(0, i + 1) for i in range(arms)],
        list(range(1, arms + 1)),
    )


def _chain(rng: random.Random, links: int) -> tuple[np.ndarray, list, list]:
    """A cable in many parts between two supports."""
    t = np.linspace(0, 1, links + 1)
    nodes = np.column_stack([t * links, np.zeros_like(t), rng.uniform(-1, 0) * np.sin(np.pi * t)])
    return nodes, [(i, i + 1) for i in range(links)], [0, links]


def random_net(rng: random.Random) -> dict:
    """A net as taut's own JSON, within what the format allows."""
    parts = []
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        kind = rng.random()
        if kind < 0.75:
            parts.append(_grid(rng, rng.randint(3, 9), rng.randint(3, 9)))
        elif kind < 0.88:
            parts.append(_star(rng, rng.choice([3, 4, 10, 100, 500])))
        else:
            parts.append(_chain(rng, rng.choice([2, 3, 10, 100, 1000])))
    nodes, edges, supports = [], [], []
    for index, (own, links, fixed) in enumerate(parts):
        first = len(nodes)
        nodes.extend((own + np.array([0.0, 0.0, 20.0 * index])).tolist())
        edges.extend([first + int(a), first + int(b)] for a, b in links)
        supports.extend(first + int(n) for n in fixed)
    nodes = np.array(nodes)
    ends = np.array(edges)
    lengths = np.linalg.norm(nodes[ends[:, 0]] - nodes[ends[:, 1]], axis=1)
    # Short by a little, as cut; or some far too long, so that they go slack.
    factor = np.array([rng.uniform(0.9, 0.9999) for _ in edges])
    if rng.random() < 0.4:
        slack = [rng.random() < rng.choice([0.05, 0.5, 1.0]) for _ in edges]
        factor[slack] = [rng.uniform(1.0, 3.0) for s in slack if s]
    stiffness = np.full(len(edges), 10 ** rng.uniform(3, 7))
    if rng.random() < 0.4:
        stiffness = np.array([10 ** rng.uniform(3, 9) for _ in edges])
    loads = np.zeros_like(nodes)
    if rng.random() < 0.6:
        loads[:, 2] = -(10 ** rng.uniform(-3, 5))
    offset = rng.choice([0.0, 0.0, 1e3, 1e6])
    nodes = nodes + np.array([offset, -offset, 0.0])
    is_far = rng.random() < 0.15
    if is_far:  # a free node absurdly far off
        free = sorted(set(range(len(nodes))) - set(supports))
        nodes[rng.choice(free)] = [rng.choice([-1, 1]) * 10 ** rng.uniform(3, 14) for _ in range(3)]
    scale = rng.choice([1.0, 1.0, 1e-3, 1e3])
    net = {
        "format": "taut-net",
        "version": 1,
        "name": "far" if is_far else "near",
        "nodes": (scale * nodes).tolist(),
        "supports": supports,
        "edges": edges,
        "axial_stiffness": stiffness.tolist(),
        "unstressed_lengths": (scale * lengths * factor).tolist(),
        "adjustable": sorted(rng.sample(range(len(edges)), rng.randint(0, len(edges) // 4))),
    }
    if loads.any():
        net["loads"] = loads.tolist()
    return net


def out_of_balance(net: dict, form: np.ndarray) -> tuple[float, float, float, float]:
    """Largest force left at a free node, all tensions' sum, what rounding of coordinates explains [N]; and all edges'
    slack [m]."""
    edges = np.array(net["edges"])
    stiffness = np.array(net["axial_stiffness"])
    slack_length = np.array(net["unstressed_lengths"])
    # Differences from a support keep the digits that coordinates of a national grid lose.
    near = form - form[net["supports"][0]]
    span = near[edges[:, 1]] - near[edges[:, 0]]
    length = np.linalg.norm(span, axis=1)
    tension = np.maximum(0.0, stiffness * (length - slack_length) / slack_length)
    force = np.where(length > 0, tension / np.where(length > 0, length, 1.0), 0.0)[:, None] * span
    total = np.array(net.get("loads", np.zeros_like(form)), dtype=float)
    np.add.at(total, edges[:, 0], force)
    np.add.at(total, edges[:, 1], -force)
    free = np.setdiff1d(np.arange(len(form)), net["supports"])
    left = np.linalg.norm(total[free], axis=1).max()
    last_place = 4 * np.finfo(float).eps * np.abs(form).max()
    rounding = np.zeros(len(form))
    np.add.at(rounding, edges[:, 0], last_place * stiffness / slack_length)
    np.add.at(rounding, edges[:, 1], last_place * stiffness / slack_length)
    return left, tension.sum(), rounding.max(), np.maximum(0.0, slack_length - length).sum()


def to_json(net: dict) -> str:
    """The net's file."""
    return json.dumps(net)
