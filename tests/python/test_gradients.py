# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a gradient of another function than the form."""

import numpy as np
import pytest
import taut
from taut import gradients


def distance(net, lengths, target):
    return float(np.sum((taut.solve_equilibrium(net, lengths).form - target) ** 2))


def test_the_gradient_is_that_of_finite_differences(net):
    lengths = net.unstressed_lengths * 0.9995
    target = net.nodes + 0.01
    form, pullback = gradients.form_vjp(net, lengths)
    gradient = pullback(2.0 * (form - target))
    step = 1e-6
    for edge in (0, 7, int(net.adjustable_edges[0]), len(net.edges) - 1):
        change = np.zeros(len(lengths))
        change[edge] = step
        slope = distance(net, lengths + change, target) - distance(net, lengths - change, target)
        assert gradient[edge] == pytest.approx(slope / (2 * step), rel=1e-5, abs=1e-9)


def test_wrong_shapes_are_refused(net):
    with pytest.raises(ValueError, match="shape"):
        gradients.form_vjp(net, net.unstressed_lengths)[1](np.zeros(3))
    with pytest.raises(ValueError, match="unstressed_lengths"):
        gradients.form_vjp(net, [1.0])


def test_scipy_finds_lengths_for_a_form(net):
    optimize = pytest.importorskip("scipy.optimize")
    wanted = np.array(net.unstressed_lengths)
    wanted[net.adjustable_edges[::2]] -= 1e-3
    target = taut.solve_equilibrium(net, wanted).form

    def value_and_slope(lengths):
        form, pullback = gradients.form_vjp(net, lengths)
        return 1e6 * np.sum((form - target) ** 2), 1e6 * pullback(2.0 * (form - target))

    start = np.array(net.unstressed_lengths)
    bounds = [(0.99 * at, 1.01 * at) for at in start]
    found = optimize.minimize(value_and_slope, start, jac=True, method="L-BFGS-B", bounds=bounds)
    assert distance(net, found.x, target) < 1e-3 * distance(net, start, target)


def test_jax_has_the_same_gradient(net):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    form = gradients.jax_form(net)
    target = net.nodes + 0.01
    lengths = np.array(net.unstressed_lengths)

    def objective(at):
        return ((form(at) - target) ** 2).sum()

    solved, pullback = gradients.form_vjp(net, lengths)
    expected = pullback(2.0 * (solved - target))
    assert np.asarray(jax.grad(objective)(lengths)) == pytest.approx(expected, abs=1e-12)
    assert np.asarray(jax.jit(jax.grad(objective))(lengths)) == pytest.approx(expected, abs=1e-12)


def test_torch_has_the_same_gradient(net):
    torch = pytest.importorskip("torch")
    target = torch.tensor(np.array(net.nodes) + 0.01)
    lengths = torch.tensor(np.array(net.unstressed_lengths), requires_grad=True)
    ((gradients.torch_form(net)(lengths) - target) ** 2).sum().backward()
    solved, pullback = gradients.form_vjp(net, net.unstressed_lengths)
    expected = pullback(2.0 * (solved - target.numpy()))
    assert lengths.grad.numpy() == pytest.approx(expected, abs=1e-12)
