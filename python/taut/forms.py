# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What gradients.py makes derivatives of for JAX and PyTorch: five functions of lengths l.

    value(l)         the form r (n, 3)
    push(l, v)       r'[v] (n, 3), for changes v of the lengths (m,)
    pull(l, c)       c . r' (m,), for a cotangent c of the form (n, 3)
    push2(l, v, w)   r''[v, w] (n, 3)
    pull2(l, c, v)   c . r''[v, .] (m,)

All but value are linear in what comes after l, and the transposes and the derivatives of the first
three are among them: ALONG and TRANSPOSED.
"""

from __future__ import annotations

import math
import threading
import warnings
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut

Array = NDArray[np.float64]

NAMES = ("value", "push", "pull", "push2", "pull2")

#: The derivative along a change of the lengths, which comes as one more argument.
ALONG = {"value": "push", "push": "push2", "pull": "pull2"}

#: The transpose with respect to argument i after the lengths: a function, and what it takes after
#: the lengths: 0 is the cotangent, 1 and 2 are the arguments.
TRANSPOSED: dict[tuple[str, int], tuple[str, tuple[int, ...]]] = {
    ("push", 0): ("pull", (0,)),
    ("pull", 0): ("push", (0,)),
    ("push2", 0): ("pull2", (0, 2)),
    ("push2", 1): ("pull2", (0, 1)),
    ("pull2", 0): ("push2", (0, 2)),
    ("pull2", 1): ("pull2", (1, 0)),
}

NO_THIRD = "third derivatives of the form are not implemented: taut has first and second ones"


def transposed(name: str, i: int, cotangent: Any, linear: Any) -> tuple[str, list[Any]]:
    """A function and its arguments after the lengths, by TRANSPOSED."""
    other, places = TRANSPOSED[name, i]
    return other, [(cotangent, *linear)[place] for place in places]


class Solution:
    """The form for some lengths, and its derivatives there: by one factor of the stiffness, made
    when the first is asked for."""

    def __init__(
        self,
        net: _taut.CableNet,
        solver: _taut.EquilibriumSolver,
        lengths: Array,
        start: ArrayLike | None = None,
    ):
        self._net = net
        found = solver.solve(lengths, start)
        self._lengths = found.unstressed_lengths.copy()  # where runs slide, not those given
        if not found.is_balanced:
            raise ArithmeticError(f"no equilibrium: {found!r}")
        if found.status != "converged":
            warnings.warn(
                "slack edges leave nodes loose: these have no form of their own, and their "
                "derivatives are 0",
                RuntimeWarning,
                stacklevel=4,
            )
        self.form: Array = found.form

    @cached_property
    def _sensitivity(self) -> _taut.FormSensitivity:
        return _taut.FormSensitivity(self._net, self._lengths, self.form)

    def value(self) -> Array:
        return self.form

    def push(self, change: Array) -> Array:
        return self._of_all_nodes(self._sensitivity.apply(change))

    def pull(self, cotangent: Array) -> Array:
        return self._sensitivity.apply_transposed(self._of_free_nodes(cotangent))

    def pull_net(self, cotangent: Array) -> dict[str, Array]:
        return self._sensitivity.net_gradient(cotangent)

    def push2(self, change: Array, more: Array) -> Array:
        return self._of_all_nodes(self._sensitivity.apply_second(change, more))

    def pull2(self, cotangent: Array, change: Array) -> Array:
        return self._sensitivity.apply_second_transposed(self._of_free_nodes(cotangent), change)

    def _of_free_nodes(self, of_all: Array) -> Array:
        return of_all[self._net.free_nodes].ravel()

    def _of_all_nodes(self, free: Array) -> Array:
        moves = np.zeros(self.form.shape)
        moves[self._net.free_nodes] = free.reshape(-1, 3)
        return moves


class Forms:
    """The five functions for a net, of batches. Keeps the last solutions, so that value and
    derivatives for the same lengths are one solve. May be used by several threads."""

    def __init__(
        self,
        net: _taut.CableNet,
        solver: _taut.EquilibriumSolver | None = None,
        most_kept: int | None = None,
    ):
        """Keeps all solutions unless most_kept is given: then as many, or those of the last batch
        where that has more."""
        self.net = net
        self._solver = solver or _taut.EquilibriumSolver(net)
        self._most_kept = most_kept
        self._kept: dict[
            bytes, Solution
        ] = {}  # by the bytes of the lengths, the last used at the end
        self._lock = threading.Lock()

    def shape(self, name: str) -> tuple[int, ...]:
        """Of a result that is no batch."""
        edges, nodes = (len(self.net.edges),), (len(self.net.nodes), 3)
        return edges if name.startswith("pull") else nodes

    def check(self, shape: tuple[int, ...], is_floating: bool, dtype: object) -> None:
        """Raises unless these are of lengths."""
        if shape != (expected := self.shape("pull")):
            raise ValueError(f"unstressed_lengths: got the shape {shape}, expected {expected}")
        if not is_floating:
            raise TypeError(f"unstressed_lengths: got {dtype}, expected floating point numbers")

    def each(self, name: str, *arguments: ArrayLike) -> Array:
        """A function of each of a batch: arguments with the same leading axes, if any."""
        lengths, *others = (np.asarray(one, dtype=float) for one in arguments)
        batch = lengths.shape[:-1]
        result = np.empty(batch + self.shape(name))
        for at in np.ndindex(batch):
            solution = self._solution(lengths[at], math.prod(batch))
            result[at] = getattr(solution, name)(*(one[at] for one in others))
        return result

    def _solution(self, lengths: Array, batch_size: int) -> Solution:
        key = lengths.tobytes()
        with self._lock:
            found = self._kept.pop(key, None) or Solution(self.net, self._solver, lengths)
            self._kept[key] = found
            while self._most_kept and len(self._kept) > max(self._most_kept, batch_size):
                del self._kept[next(iter(self._kept))]
        return found
