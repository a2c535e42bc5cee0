# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a form that is not the program's, and derivatives that are not the form's."""

import threading

import numpy as np
import pytest
import taut


def test_the_form_balances_the_loads(net):
    found = taut.solve_equilibrium(net)
    assert found.status == "converged"
    assert found.is_balanced
    assert "converged" in repr(found)
    told = found.to_dict()
    assert told["status"] == "converged"
    assert np.array_equal(told["form"], found.form)
    assert told["iterations"] == found.iterations
    tensions = taut.tensions(net, net.unstressed_lengths, found.form)
    edges = net.edges
    along = found.form[edges[:, 1]] - found.form[edges[:, 0]]
    lengths = np.linalg.norm(along, axis=1)
    assert lengths == pytest.approx(taut.edge_lengths(net, found.form), abs=1e-15)
    pull = along / lengths[:, None] * tensions[:, None]
    forces = np.array(net.loads) if len(net.loads) else np.zeros_like(net.nodes)
    np.add.at(forces, edges[:, 0], pull)
    np.add.at(forces, edges[:, 1], -pull)
    assert np.abs(forces[net.free_nodes]).max() < 1e-9 * tensions.max()


def test_a_solver_takes_other_lengths_and_starts(net):
    solver = taut.EquilibriumSolver(net)
    lengths = net.unstressed_lengths * 0.999
    first = solver.solve(lengths)
    again = solver.solve(lengths, start=first.form)
    assert np.abs(again.form - first.form).max() < 1e-9
    assert np.array_equal(taut.solve_equilibrium(net, lengths).form, first.form)
    with pytest.raises(ValueError, match="start"):
        solver.solve(lengths, start=np.zeros((2, 3)))
    with pytest.raises(ValueError, match="unstressed_lengths"):
        solver.solve(lengths[:-1])
    with pytest.raises(ValueError, match="positive"):
        solver.solve(-lengths)


def test_what_does_not_converge_says_so(net):
    lengths = np.array(net.unstressed_lengths)
    lengths[net.adjustable_edges[::2]] *= 0.9
    found = taut.solve_equilibrium(net, lengths, max_iterations=1)
    assert not found.is_balanced
    assert found.status == "iteration limit"


def test_sensitivities_are_the_slope_of_the_form(net):
    form = taut.solve_equilibrium(net).form
    sensitivity = taut.FormSensitivity(net, net.unstressed_lengths, form)
    edge = int(net.interior_edges[10])
    step = np.zeros(len(net.edges))
    step[edge] = 1e-6
    solver = taut.EquilibriumSolver(net)
    above = solver.solve(net.unstressed_lengths + step).form
    below = solver.solve(net.unstressed_lengths - step).form
    slope = ((above - below) / 2e-6)[net.free_nodes].ravel()
    assert sensitivity.columns([edge])[0] == pytest.approx(slope, abs=1e-6)
    assert sensitivity.apply(step) == pytest.approx(1e-6 * slope, abs=1e-12)


def test_one_solver_serves_one_thread_at_a_time_and_many_serve_many(net):
    shared = taut.EquilibriumSolver(net)
    expected = shared.solve(net.unstressed_lengths * 0.999).form
    wrong = []

    def work(solver):
        for _ in range(500):
            if not np.array_equal(solver.solve(net.unstressed_lengths * 0.999).form, expected):
                wrong.append(solver)

    threads = [threading.Thread(target=work, args=(shared,)) for _ in range(3)]
    threads += [threading.Thread(target=work, args=(taut.EquilibriumSolver(net),))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
