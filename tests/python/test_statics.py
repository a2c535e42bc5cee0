# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against arrays in another order or shape than C++ has them, and shared solvers."""

import threading

import numpy as np
import pytest
import taut


def test_a_form_is_shown_with_its_status(net):
    found = taut.solve_equilibrium(net)
    assert found.status == "converged"
    assert found.is_balanced
    assert "converged" in repr(found)
    entries = found.to_dict()
    assert entries["status"] == "converged"
    assert np.array_equal(entries["form"], found.form)
    assert entries["iterations"] == found.iterations
    along = found.form[net.edges[:, 1]] - found.form[net.edges[:, 0]]
    lengths = np.linalg.norm(along, axis=1)
    assert taut.edge_lengths(net, found.form) == pytest.approx(lengths, abs=1e-15)
    tensions = taut.tensions(net, net.unstressed_lengths, found.form)
    strain = lengths / net.unstressed_lengths - 1.0
    assert tensions == pytest.approx(np.maximum(0.0, net.axial_stiffness * strain))


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


def test_what_does_not_converge_says_so(net):
    lengths = np.array(net.unstressed_lengths)
    lengths[net.adjustable_edges[::2]] *= 0.9
    found = taut.solve_equilibrium(net, lengths, max_iterations=1)
    assert not found.is_balanced
    assert found.status == "iteration limit"


def test_rows_of_sensitivities_are_of_edges(net):
    form = taut.solve_equilibrium(net).form
    sensitivity = taut.FormSensitivity(net, net.unstressed_lengths, form)
    edge = int(net.interior_edges[10])
    step = np.zeros(len(net.edges))
    step[edge] = 1e-6
    assert sensitivity.columns([edge])[0] == pytest.approx(1e6 * sensitivity.apply(step), abs=1e-9)


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


def test_a_form_that_is_no_equilibrium_has_no_sensitivity(net):
    lifted = np.array(net.nodes)
    lifted[net.free_nodes, 2] += 0.01
    with pytest.raises(ValueError, match="form: is no equilibrium of unstressed_lengths: up to"):
        taut.FormSensitivity(net, net.unstressed_lengths, lifted)


def test_lengths_in_another_unit_are_seen(net):
    with pytest.raises(RuntimeError, match=r"no edge carries a force .* Check units"):
        taut.inspect(net.with_lengths(1e3 * net.unstressed_lengths))
