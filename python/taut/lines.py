# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Nets from lines and points, as Rhino, Grasshopper and other drawing programs hold them."""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut

Array = NDArray[np.float64]


def coordinates(points: Iterable[Any] | None) -> Array:
    """Points that have X, Y and Z, or are three numbers each, as an array (k, 3)."""
    try:
        rows = [
            (point.X, point.Y, point.Z) if hasattr(point, "X") else tuple(point)
            for point in (() if points is None else points)
        ]
    except TypeError:
        raise TypeError("points: got no list of points, expected x, y and z of each") from None
    if any(len(row) != 3 for row in rows):
        raise ValueError("points: got other than three coordinates, expected x, y and z of each")
    return np.array(rows, dtype=float).reshape(-1, 3)


def _segments(lines: Iterable[Any] | None) -> Array:
    """Both ends of each line, and of each piece of a polyline, in their order (m, 2, 3)."""
    pairs = [np.empty((0, 2, 3))]
    for line in () if lines is None else lines:
        points = coordinates((line.From, line.To) if hasattr(line, "From") else line)
        pairs.append(np.stack([points[:-1], points[1:]], axis=1))
    if len(pairs) == 1:
        raise ValueError("lines: got none, expected one for each cable between two nodes")
    return np.concatenate(pairs)


class _Nodes:
    """Points closer than a tolerance are one node. They are looked up in cells of that size."""

    def __init__(self, tolerance: float) -> None:
        self.places: list[Array] = []
        self._tolerance = tolerance
        self._cells: dict[tuple[int, ...], list[int]] = {}

    def _cell(self, point: Array) -> tuple[int, ...]:
        return tuple(int(one) for one in np.floor(point / self._tolerance))

    def find(self, point: Array) -> int | None:
        x, y, z = self._cell(point)
        for i, j, k in itertools.product((0, -1, 1), repeat=3):
            for node in self._cells.get((x + i, y + j, z + k), ()):
                if np.linalg.norm(self.places[node] - point) <= self._tolerance:
                    return node
        return None

    def add(self, point: Array) -> int:
        node = self.find(point)
        if node is None:
            node = len(self.places)
            self.places.append(point)
            self._cells.setdefault(self._cell(point), []).append(node)
        return node


def _of_each(given: ArrayLike, name: str, count: int) -> Array:
    """One number of each line, or one for all."""
    parse = _taut._length_given if name == "unstressed_length" else _taut._force_given
    texts: Any = [given] if np.ndim(given) == 0 else given
    if np.ndim(texts) == 1 and any(isinstance(one, str) for one in texts):
        if name == "force_density":
            raise TypeError("force_density: got str, expected numbers of N/m")
        given = [parse(one, name) for one in texts]
    values = np.asarray(given, dtype=float).ravel()
    if values.size not in (1, count):
        raise ValueError(f"{name}: got {values.size} numbers, expected one, or {count} of lines")
    values = np.array(np.broadcast_to(values, count))
    if not (values >= 0.0).all():
        worst = int(np.argmax(~(values >= 0.0)))
        raise ValueError(f"{name}: got {values[worst]} at line {worst}, expected 0 or more")
    return values


def net_from_lines(
    lines: Iterable[Any] | None,
    supports: Iterable[Any] | None,
    axial_stiffness: ArrayLike,
    *,
    tension: ArrayLike | None = None,
    force_density: ArrayLike | None = None,
    unstressed_length: ArrayLike | None = None,
    loads: str = "none",
    scale: float = 1.0,
    tolerance: float = 1e-3,
    **settings: Any,
) -> _taut.CableNet:
    """A net whose edges are lines, in their order, and whose nodes are the ends of these.

    Args:
        lines: cables in the nominal form. Each has ends From and To with X, Y and Z, as a Line of
            Rhino, or is a sequence of points; a polyline is one edge from point to point.
        supports: points where lines end at the frame.
        axial_stiffness: EA of each edge, or one number for all [N], or '100kN'.
        tension: of each edge in the nominal form, or one number for all [N], or '2kN'; or
        force_density: tension over length [N/m]; or
        unstressed_length: [m].
        loads: 'none', or those that 'balance' the tensions at free nodes.
        scale: metres in a unit of the drawing.
        tolerance: ends that are closer are one node [m].
        settings: further arguments of CableNet.

    Raises:
        ValueError: naming the argument, its value and the rule.
        NetError: where the lines are no net; its edge is the index of the line.
    """
    if loads not in ("none", "balance"):
        raise ValueError(f"loads: got {loads!r}, expected 'none' or 'balance'")
    for name, value in {"scale": scale, "tolerance": tolerance}.items():
        if not isinstance(value, Real) or not 0.0 < value < float("inf"):
            raise ValueError(f"{name}: got {value!r}, expected a number above 0")
    nodes = _Nodes(tolerance)
    edges = np.array([[nodes.add(end) for end in ends] for ends in scale * _segments(lines)])
    fixed = [nodes.find(point) for point in scale * coordinates(supports)]
    if None in fixed:
        raise ValueError(
            f"supports: got at {fixed.index(None)} a point where no line ends, expected the end of "
            f"one within {tolerance} m"
        )
    form = np.array(nodes.places)
    vectors = form[edges[:, 0]] - form[edges[:, 1]]
    lengths = np.linalg.norm(vectors, axis=1)
    given = {
        name: _of_each(values, name, len(edges))
        for name, values in {
            "tension": tension,
            "force_density": force_density,
            "unstressed_length": unstressed_length,
        }.items()
        if values is not None
    }
    if len(given) != 1:
        raise ValueError(
            f"tension, force_density, unstressed_length: got {len(given)} of them, expected one"
        )
    stiffness = _of_each(axial_stiffness, "axial_stiffness", len(edges))
    if unstressed_length is None:
        forces = given["tension"] if force_density is None else given["force_density"] * lengths
        unstressed = _taut.unstressed_lengths_for(lengths, forces, stiffness)
    else:
        unstressed = given["unstressed_length"]
    if loads == "balance":
        forces = np.maximum(stiffness * (lengths / unstressed - 1.0), 0.0)
        pulls = (forces / lengths)[:, None] * vectors
        settings["loads"] = np.zeros_like(form)
        np.add.at(settings["loads"], edges[:, 0], pulls)
        np.add.at(settings["loads"], edges[:, 1], -pulls)
        settings["loads"][fixed] = 0.0
    return _taut.CableNet(form, sorted(set(fixed)), edges, stiffness, unstressed, **settings)
