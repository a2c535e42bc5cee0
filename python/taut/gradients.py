# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The equilibrium form as a differentiable function of unstressed lengths: for NumPy, JAX, PyTorch.

    form, pullback = taut.gradients.form_vjp(net, lengths)
    gradient = pullback(2.0 * (form - target))   # of |form - target|^2, by each length

Derivatives are those of the implicit function theorem: one factorisation of the stiffness, which
all of them then use. By a slack edge they are 0. Where an edge is about to go slack, the form has a
kink, and the derivatives are those of one side.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut
from taut.forms import Forms, Solution

Gradient = TypeVar("Gradient")

__all__ = ["form_vjp", "jax_form", "net_vjp", "torch_form"]


def form_vjp(
    net: _taut.CableNet, unstressed_lengths: ArrayLike, *, start: ArrayLike | None = None
) -> tuple[NDArray[np.float64], Callable[[ArrayLike], NDArray[np.float64]]]:
    """The form for some lengths, and its vector-Jacobian product.

    Args:
        net: whose form it is.
        unstressed_lengths: of all edges (m,) [m].
        start: form to begin from (n, 3), by default the net's nodes [m].

    Returns:
        The form (n, 3) [m], and a function of a cotangent (n, 3) that gives the gradient with
            respect to unstressed_lengths (m,).

    Raises:
        ArithmeticError: where forces do not balance: there is no form to derive.

    Warns:
        RuntimeWarning: where slack edges leave nodes loose. Such a node has no form of its own, and
            its derivatives are 0; where all edges are slack, the whole gradient is.
    """
    lengths = np.array(unstressed_lengths, subok=True)  # solve() refuses masks and other dtypes
    return _vjp(net, lengths, start, Solution.pull)


def net_vjp(
    net: _taut.CableNet, *, start: ArrayLike | None = None
) -> tuple[NDArray[np.float64], Callable[[ArrayLike], dict[str, NDArray[np.float64]]]]:
    """The form of a net, and its vector-Jacobian product by all that determines it.

    Args:
        net: whose form it is, for its own lengths.
        start: form to begin from (n, 3), by default the net's nodes [m].

    Returns:
        The form (n, 3) [m], and a function of a cotangent (n, 3) that gives a dict of gradients by
            the net's `unstressed_lengths` (m,), `axial_stiffness` (m,; 0 for an edge with a
            tension law), `loads` (n, 3; 0 at supports) and `nodes` (n, 3; the places of supports,
            of elastic ones without load; 0 at other nodes).

    Raises and warns as form_vjp does.
    """
    return _vjp(net, net.unstressed_lengths, start, Solution.pull_net)


def _vjp(
    net: _taut.CableNet,
    lengths: NDArray[Any],
    start: ArrayLike | None,
    pull: Callable[[Solution, NDArray[np.float64]], Gradient],
) -> tuple[NDArray[np.float64], Callable[[ArrayLike], Gradient]]:
    solution = Solution(net, _taut.EquilibriumSolver(net), lengths, start)
    shape = solution.form.shape

    def pullback(cotangent: ArrayLike) -> Gradient:
        cotangent = np.asarray(cotangent, dtype=float)
        if cotangent.shape != shape:
            raise ValueError(f"cotangent: got the shape {cotangent.shape}, expected {shape}")
        return pull(solution, cotangent)

    return solution.form, pullback


def jax_form(net: _taut.CableNet) -> Callable[[Any], Any]:
    """form(lengths) for JAX: (m,) to (n, 3). First and second derivatives in either mode (grad,
    jvp, jacfwd, jacrev, hessian), jit and vmap; third derivatives raise NotImplementedError. Value
    and derivatives for the same lengths are one solve. Warns as form_vjp does.

    JAX computes in single precision by default: jax.config.update("jax_enable_x64", True).
    """
    try:
        from taut.forms_jax import PRIMITIVES, jnp
    except ImportError as error:
        raise ImportError("jax_form needs JAX: pip install jax") from error

    forms = Forms(net, most_kept=4)

    def form(lengths: Any) -> Any:
        lengths = jnp.asarray(lengths)
        forms.check(lengths.shape, jnp.issubdtype(lengths.dtype, jnp.floating), lengths.dtype)
        return PRIMITIVES["value"].bind(lengths, forms=forms)

    return form


def torch_form(net: _taut.CableNet) -> Callable[[Any], Any]:
    """form(lengths) for PyTorch: (m,) to (n, 3), computed on the CPU. First and second derivatives
    by torch.autograd and torch.func in either mode, and vmap; third derivatives raise
    NotImplementedError. A derivative does not solve for the form again. Warns as form_vjp does.

    torch.compile leaves the call as it is, between two compiled parts; with fullgraph=True it says
    so.
    """
    try:
        from taut.forms_torch import FUNCTIONS, torch
    except ImportError as error:
        raise ImportError("torch_form needs PyTorch: pip install torch") from error

    solver = _taut.EquilibriumSolver(net)

    def solved(lengths: Any) -> Any:
        lengths = torch.as_tensor(lengths)
        forms = Forms(net, solver)
        forms.check(tuple(lengths.shape), lengths.is_floating_point(), lengths.dtype)
        return FUNCTIONS["value"].apply(forms, lengths)

    def form(lengths: Any) -> Any:
        if torch.compiler.is_compiling():  # not before: to import the compiler takes seconds
            torch._dynamo.graph_break(msg="taut solves for the form outside of PyTorch")
            return torch.compiler.disable(solved)(lengths)
        return solved(lengths)

    return form
