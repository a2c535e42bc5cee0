# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against derivatives of another function than the form, and against a second solve."""

import subprocess
import sys

import numpy as np
import pytest
import taut
from taut import forms, gradients

# PyTorch's own, where it first uses the forward mode
pytestmark = pytest.mark.filterwarnings("ignore:`torch.jit:FutureWarning")


def distance(net, lengths, target):
    return float(np.sum((taut.solve_equilibrium(net, lengths).form - target) ** 2))


@pytest.fixture(scope="module")
def target(net):
    return net.nodes + 0.01


@pytest.fixture(scope="module")
def lengths(net):
    return net.unstressed_lengths * 0.9995


@pytest.fixture(scope="module")
def gradient_of(net, target):
    """The gradient of sum((form - target)^2) + sum(lengths^2), by form_vjp."""

    def gradient(lengths):
        form, pullback = gradients.form_vjp(net, lengths)
        return pullback(2.0 * (form - target)) + 2.0 * lengths

    return gradient


@pytest.fixture(scope="module")
def hessian(lengths, gradient_of):
    """The Hessian of the same, by central differences of fourth order."""

    def row(change):
        near = gradient_of(lengths + change) - gradient_of(lengths - change)
        far = gradient_of(lengths + 2 * change) - gradient_of(lengths - 2 * change)
        return (8 * near - far) / (12 * 1e-5)

    return np.array([row(change) for change in 1e-5 * np.eye(len(lengths))])


@pytest.fixture
def solves(monkeypatch):
    """One entry for each equilibrium that is solved."""
    entries = []
    solve = forms.Solution.__init__

    def counted(self, *arguments):
        entries.append(1)
        solve(self, *arguments)

    monkeypatch.setattr(forms.Solution, "__init__", counted)
    return entries


def same(got, expected, rel=1e-8):
    got, expected = np.asarray(got), np.asarray(expected)
    return got.shape == expected.shape and np.linalg.norm(got - expected) <= rel * np.linalg.norm(
        expected
    )


def test_wrong_shapes_are_refused(net):
    with pytest.raises(ValueError, match="shape"):
        gradients.form_vjp(net, net.unstressed_lengths)[1](np.zeros(3))
    with pytest.raises(ValueError, match="unstressed_lengths"):
        gradients.form_vjp(net, [1.0])


def test_a_gradient_of_slack_edges_warns(net):
    with pytest.warns(RuntimeWarning, match="slack edges leave nodes loose") as warned:
        form, pullback = gradients.form_vjp(net, 1.1 * net.unstressed_lengths)
    assert warned[0].filename == __file__
    assert not pullback(np.ones(form.shape)).any()


def test_the_gradient_by_the_net_is_that_of_finite_differences(net):
    loads = np.zeros_like(net.nodes)
    loads[net.free_nodes] = [0.0, 10.0, -20.0]
    parts = {
        "unstressed_lengths": net.unstressed_lengths,
        "axial_stiffness": net.axial_stiffness,
        "loads": loads,
        "nodes": net.nodes,
    }
    steps = {"unstressed_lengths": 1e-6, "axial_stiffness": 10.0, "loads": 0.1, "nodes": 1e-6}

    def loaded(**changed):
        given = parts | changed
        return taut.CableNet(
            given["nodes"],
            net.supports,
            net.edges,
            given["axial_stiffness"],
            given["unstressed_lengths"],
            loads=given["loads"],
        )

    weights = np.random.default_rng(1).normal(size=net.nodes.shape)
    _, pullback = gradients.net_vjp(loaded())
    gradient = pullback(weights)
    assert set(gradient) == set(parts)
    assert same(
        gradient["unstressed_lengths"],
        gradients.form_vjp(loaded(), parts["unstressed_lengths"])[1](weights),
        1e-12,
    )
    assert not gradient["nodes"][net.free_nodes].any()
    assert not gradient["loads"][net.supports].any()
    for name, part in parts.items():
        change = np.random.default_rng(2).normal(size=part.shape) * steps[name]
        there, back = (
            taut.solve_equilibrium(loaded(**{name: part + sign * change})).form for sign in (1, -1)
        )
        slope = np.sum(weights * (there - back)) / 2.0
        assert np.sum(gradient[name] * change) == pytest.approx(slope, rel=1e-5)


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


def test_solutions_are_kept_to_a_number_or_all(net, lengths, solves):
    few, all_of_them = forms.Forms(net, most_kept=2), forms.Forms(net)
    several = np.array([lengths * (1.0 - 1e-5 * k) for k in range(4)])
    for kept in (few, all_of_them):
        kept.each("value", several)
        kept.each("pull", several, np.ones((4, *kept.shape("value"))))
    assert len(solves) == 8  # a batch is kept whole
    for kept, expected in ((few, 2), (all_of_them, 0)):
        solves.clear()
        for k in (3, 2, 3, 2, 1, 3):
            kept.each("value", several[k])
        assert len(solves) == expected


@pytest.fixture(scope="module")
def jax():
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    return jax


@pytest.fixture
def jax_objective(jax, net, target):
    form = gradients.jax_form(net)
    return lambda at: jax.numpy.sum((form(at) - target) ** 2) + (at**2).sum()


def test_in_jax_the_gradient_is_that_of_form_vjp(jax, jax_objective, lengths, gradient_of):
    expected = gradient_of(lengths)
    for gradient in (jax.grad, jax.jacfwd):
        assert same(gradient(jax_objective)(lengths), expected, 1e-12)
        assert same(jax.jit(gradient(jax_objective))(lengths), expected, 1e-12)


def test_in_jax_value_and_gradient_are_one_solve(jax, jax_objective, lengths, solves):
    jax.value_and_grad(jax_objective)(lengths)
    assert len(solves) == 1
    jax.jit(jax.value_and_grad(jax_objective))(0.9999 * lengths)
    assert len(solves) == 2
    jax_objective(0.9999 * lengths)
    jax.hessian(jax_objective)(0.9999 * lengths)
    assert len(solves) == 2


def test_in_jax_second_derivatives_are_those_of_finite_differences(
    jax, jax_objective, lengths, hessian
):
    v = np.linspace(-1.0, 1.0, len(lengths))
    slope = jax.grad(jax_objective)
    assert same(jax.jit(jax.hessian(jax_objective))(lengths), hessian)
    assert same(jax.jacrev(slope)(lengths), hessian)
    assert same(jax.jacfwd(jax.jacfwd(jax_objective))(lengths), hessian)
    assert same(jax.jacrev(jax.jacfwd(jax_objective))(lengths), hessian)
    assert same(jax.jvp(slope, (lengths,), (v,))[1], hessian @ v)
    assert same(jax.grad(lambda at: slope(at) @ v)(lengths), hessian @ v)


def test_in_jax_vmap_is_a_loop(jax, net, jax_objective, lengths, gradient_of, hessian, solves):
    form = gradients.jax_form(net)
    several = np.array([lengths, 0.9999 * lengths, 1.0001 * lengths])
    expected = np.array([gradient_of(at) for at in several])
    solves.clear()
    assert same(jax.vmap(jax.grad(jax_objective))(several), expected, 1e-12)
    assert len(solves) == 3
    assert same(jax.vmap(jax.vmap(jax.grad(jax_objective)))(several[None])[0], expected, 1e-12)
    alike = jax.vmap(form, in_axes=1)(several.T)
    assert same(alike, [form(at) for at in several], 1e-12)
    assert same(jax.jit(jax.vmap(jax.hessian(jax_objective)))(several)[0], hessian)
    # The lengths are the same for all, the change is not, and the other way round.
    v = np.linspace(-1.0, 1.0, len(lengths))
    push = jax.vmap(lambda at, to: jax.jvp(jax_objective, (at,), (to,))[1], in_axes=(None, 0))
    assert same(push(lengths, np.array([v, 2 * v])), np.array([1, 2]) * (expected[0] @ v))
    summed = jax.grad(lambda to: jax.vmap(lambda at: jax.jvp(form, (at,), (to,))[1])(several).sum())
    assert same(summed(v), sum(jax.grad(lambda to: form(to).sum())(at) for at in several))


def test_in_jax_third_derivatives_raise(jax, jax_objective, lengths):
    v = np.linspace(-1.0, 1.0, len(lengths))

    def second(at):
        return jax.jvp(jax.grad(jax_objective), (at,), (v,))[1] @ v

    with pytest.raises(NotImplementedError, match="third derivatives"):
        jax.jvp(second, (lengths,), (v,))
    with pytest.raises(NotImplementedError, match="third derivatives"):
        jax.jit(jax.grad(second))(lengths)


def test_in_jax_wrong_lengths_are_refused_when_traced(jax, net, lengths):
    form = gradients.jax_form(net)
    for of_form in (
        form,
        jax.jit(form),
        jax.jacrev(form),
        jax.vmap(jax.vmap(form)),
    ):
        with pytest.raises(ValueError, match=r"got the shape \(.*\), expected \(60,\)"):
            of_form(lengths.reshape(1, 5, 12))
    with pytest.raises(TypeError, match="int"):
        form(np.ones(60, dtype=int))


@pytest.fixture(scope="module")
def torch():
    return pytest.importorskip("torch")


@pytest.fixture
def at(torch, lengths):
    return torch.tensor(lengths, requires_grad=True)


@pytest.fixture
def torch_objective(torch, net, target):
    form, goal = gradients.torch_form(net), torch.tensor(target)
    return lambda at: ((form(at) - goal) ** 2).sum() + (at**2).sum()


def test_in_torch_the_gradient_is_that_of_form_vjp(
    torch, torch_objective, at, lengths, gradient_of
):
    torch_objective(at).backward()
    expected = gradient_of(lengths)
    assert same(at.grad, expected, 1e-12)
    for gradient in (torch.func.grad, torch.func.jacrev, torch.func.jacfwd):
        assert same(gradient(torch_objective)(at.detach()), expected, 1e-12)


def test_in_torch_a_backward_does_not_solve_again(torch, torch_objective, at, solves):
    both = torch_objective(at) + torch_objective(0.9999 * at)
    assert len(solves) == 2
    (gradient,) = torch.autograd.grad(both, at, create_graph=True)
    gradient.sum().backward()
    assert len(solves) == 2


def test_in_torch_second_derivatives_are_those_of_finite_differences(
    torch, torch_objective, at, hessian
):
    here, v = at.detach(), torch.linspace(-1.0, 1.0, len(at), dtype=torch.float64)
    of_v = hessian @ v.numpy()
    assert same(torch.autograd.functional.hessian(torch_objective, here), hessian)
    assert same(torch.autograd.functional.hvp(torch_objective, here, v)[1], of_v)
    assert same(torch.autograd.functional.vhp(torch_objective, here, v)[1], of_v)
    rev, fwd = torch.func.jacrev, torch.func.jacfwd
    for one in (rev, fwd):
        for other in (rev, fwd):
            assert same(one(other(torch_objective))(here), hessian)
    slope = torch.func.grad(torch_objective)
    assert same(torch.func.jvp(slope, (here,), (v,))[1], of_v)


def test_in_torch_all_modes_agree(torch, net, at):
    form = gradients.torch_form(net)
    check = {"eps": 1e-6, "atol": 1e-4, "fast_mode": True}
    assert torch.autograd.gradcheck(form, at, check_forward_ad=True, **check)
    assert torch.autograd.gradgradcheck(form, at, check_fwd_over_rev=True, **check)


def test_in_torch_vmap_is_a_loop(torch, net, torch_objective, at, gradient_of, hessian, solves):
    form = gradients.torch_form(net)
    several = torch.stack([at, 0.9999 * at, 1.0001 * at]).detach()
    expected = np.array([gradient_of(one.numpy()) for one in several])
    vmap, grad = torch.func.vmap, torch.func.grad
    solves.clear()
    assert same(vmap(grad(torch_objective))(several), expected, 1e-12)
    assert len(solves) == 3
    assert same(vmap(vmap(grad(torch_objective)))(several[None])[0], expected, 1e-12)
    alike = torch.stack([form(one) for one in several])
    assert same(vmap(form, in_dims=1)(several.T), alike, 1e-12)
    assert same(vmap(torch.func.hessian(torch_objective))(several)[0], hessian)


def test_in_torch_third_derivatives_raise(torch, torch_objective, at):
    (gradient,) = torch.autograd.grad(torch_objective(at), at, create_graph=True)
    (second,) = torch.autograd.grad(gradient.sum(), at, create_graph=True)
    with pytest.raises(NotImplementedError, match="third derivatives"):
        second.sum().backward()
    here, v = at.detach(), torch.ones_like(at)

    def of_v(there):
        return torch.func.jvp(torch.func.grad(torch_objective), (there,), (v,))[1] @ v

    with pytest.raises(NotImplementedError, match="third derivatives"):
        torch.func.jvp(of_v, (here,), (v,))
    with pytest.raises(NotImplementedError, match="third derivatives"):
        torch.func.grad(of_v)(here)


def test_in_torch_a_second_derivative_has_a_gradient_by_what_it_is_linear_in(torch, net, at):
    form = gradients.torch_form(net)
    c = torch.tensor(np.random.default_rng(1).normal(size=(45, 3)), requires_grad=True)
    (first,) = torch.autograd.grad(form(at), at, c, create_graph=True)
    (second,) = torch.autograd.grad(first.sum(), at, create_graph=True)
    (by_c,) = torch.autograd.grad(second.sum(), c)
    assert (by_c * c).sum().item() == pytest.approx(second.sum().item(), rel=1e-9)


def test_in_torch_wrong_lengths_are_refused(torch, net, at):
    form = gradients.torch_form(net)
    for of_form in (form, torch.func.jacrev(form), torch.func.vmap(form)):
        with pytest.raises(ValueError, match=r"got the shape \(.*\), expected \(60,\)"):
            of_form(at[:50].detach())
    with pytest.raises(TypeError, match="int64"):
        form(torch.ones(60, dtype=torch.int64))


@pytest.mark.filterwarnings("ignore:The .grad attribute")  # PyTorch looks at it
def test_in_torch_the_form_runs_between_compiled_parts_and_says_that_it_is_not_compiled(
    torch, torch_objective, at, lengths, gradient_of
):
    compiled = torch.compile(torch_objective, backend="aot_eager")
    compiled(at).backward()
    assert same(at.grad, gradient_of(lengths), 1e-12)
    with pytest.raises(Exception, match="taut solves for the form outside of PyTorch"):
        torch.compile(torch_objective, backend="eager", fullgraph=True)(at)


@pytest.mark.parametrize(("name", "package"), [("jax", "JAX"), ("torch", "PyTorch")])
def test_a_missing_package_is_named(name, package):
    code = (
        "import sys, taut\n"
        f"sys.modules['{name}'] = None\n"
        "try:\n"
        f"    taut.gradients.{name}_form(taut.hypar(2, 2))\n"
        "except ImportError as error:\n"
        "    print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == f"{name}_form needs {package}: pip install {name}"
