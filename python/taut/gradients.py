# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The equilibrium form as a differentiable function of unstressed lengths: for NumPy, JAX, PyTorch.

    form, pullback = taut.gradients.form_vjp(net, lengths)
    gradient = pullback(2.0 * (form - target))   # of |form - target|^2, by each length

The derivative is that of the implicit function theorem: one factorisation of the stiffness, which
every pullback then uses. A slack edge has a gradient of 0. Where an edge is about to go slack, the
form has a kink, and the gradient is that of one side.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut

__all__ = ["form_vjp", "jax_form", "torch_form"]


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
    """
    solver = _taut.EquilibriumSolver(net)
    lengths = np.array(unstressed_lengths, subok=True)  # solve() refuses masks and other dtypes
    found = solver.solve(lengths, start)
    if not found.is_balanced:
        raise ArithmeticError(f"no equilibrium: {found!r}")
    sensitivity = _taut.FormSensitivity(net, lengths, found.form)
    free = net.free_nodes
    shape = found.form.shape

    def pullback(cotangent):
        cotangent = np.asarray(cotangent, dtype=float)
        if cotangent.shape != shape:
            raise ValueError(f"cotangent: got the shape {cotangent.shape}, expected {shape}")
        return sensitivity.apply_transposed(cotangent[free].ravel())

    return found.form, pullback


def jax_form(net: _taut.CableNet) -> Callable:
    """form(lengths) for jax.grad and jax.jit: (m,) to (n, 3), by reverse mode.

    JAX computes in single precision by default: jax.config.update("jax_enable_x64", True).
    """
    try:
        import jax
    except ImportError as error:
        raise ImportError("jax_form needs JAX: pip install jax") from error
    import jax.numpy as jnp

    nodes, edges = len(net.nodes), len(net.edges)

    def solved(lengths):
        form, _ = form_vjp(net, lengths)
        return np.asarray(form, dtype=lengths.dtype)

    def pulled_back(lengths, cotangent):
        _, pullback = form_vjp(net, lengths)
        return np.asarray(pullback(cotangent), dtype=lengths.dtype)

    @jax.custom_vjp
    def form(lengths):
        lengths = jnp.asarray(lengths)
        shape = jax.ShapeDtypeStruct((nodes, 3), lengths.dtype)
        return jax.pure_callback(solved, shape, lengths, vmap_method="sequential")

    def forward(lengths):
        return form(lengths), jnp.asarray(lengths)

    def backward(lengths, cotangent):
        shape = jax.ShapeDtypeStruct((edges,), lengths.dtype)
        return (
            jax.pure_callback(pulled_back, shape, lengths, cotangent, vmap_method="sequential"),
        )

    form.defvjp(forward, backward)
    return form


def torch_form(net: _taut.CableNet) -> Callable:
    """form(lengths) for torch.autograd: (m,) to (n, 3), on the CPU."""
    try:
        import torch
    except ImportError as error:
        raise ImportError("torch_form needs PyTorch: pip install torch") from error

    class Form(torch.autograd.Function):
        @staticmethod
        def forward(context, lengths):
            form, context.pullback = form_vjp(net, lengths.detach().cpu().double().numpy())
            return torch.tensor(np.array(form), dtype=lengths.dtype, device=lengths.device)

        @staticmethod
        @torch.autograd.function.once_differentiable
        def backward(context, cotangent):
            gradient = context.pullback(cotangent.detach().cpu().double().numpy())
            return torch.tensor(gradient, dtype=cotangent.dtype, device=cotangent.device)

    return Form.apply
