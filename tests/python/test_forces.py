# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against evidence of force that Python misreads: frequencies, sags, known loads."""

import json

import numpy as np
import pytest
import taut


@pytest.fixture(scope="module")
def heavy(net):
    return taut.CableNet(
        net.nodes, net.supports, net.edges, net.axial_stiffness, net.unstressed_lengths, mass=1e-3
    )


def frequency_of(net, form, tension, edge, mode=1):
    start, end = net.edges[edge]
    return mode * np.sqrt(tension[edge] / 1e-3) / (2 * np.linalg.norm(form[start] - form[end]))


def test_a_frequency_is_a_force_measurement(heavy, survey, form, found):
    edges = [int(edge) for edge in heavy.interior_edges[:12:3]]
    given = [(edge, frequency_of(heavy, form, found.tension, edge), 1, 0.5) for edge in edges]
    more = {"prior": "uniform:3mm", "draws": 0, "free_length_std": 1e-3}
    sound = taut.identify(heavy, survey, frequencies=given, **more)
    assert (sound.force_measurements, sound.force_outliers) == (4, [])
    assert "mass:3%" in {one["parameter"] for one in sound.uncertain}


def test_points_of_a_sag_are_a_force_measurement(heavy, survey, form, found):
    edge = int(heavy.interior_edges[0])
    start, end = form[heavy.edges[edge]]
    x = np.array([0.2, 0.5, 0.8])[:, None]
    span = np.linalg.norm(end - start)
    weight = 1e-3 * 9.80665 * span
    middle = weight * span / (8 * found.tension[edge])
    points = start + x * (end - start) - middle * 4 * x * (1 - x) * [0, 0, 1]
    found = taut.identify(
        heavy, survey, sag=[(edge, points, 0.01 * middle)], prior="uniform:3mm", draws=0
    )
    assert found.force_measurements == 1


def test_forces_in_another_unit_are_named_and_absurd_ones_refused(net, survey, found):
    edge = int(net.interior_edges[0])
    more = {"prior": "uniform:3mm", "draws": 0}
    with pytest.warns(UserWarning, match="0.1[0-9]* times the designed one: check the unit"):
        taut.identify(net, survey, forces=[(edge, 0.1 * found.tension[edge], 1.0)], **more)
    with pytest.raises(ValueError, match="most likely the unit is kN"):
        taut.identify(net, survey, forces=[(edge, 1e-3 * found.tension[edge], 1.0)], **more)


def test_a_load_that_hung_on_the_net_at_one_survey(net, survey, built, tmp_path):
    loads = np.zeros((len(net.nodes), 3))
    loads[net.free_nodes[::4], 2] = -200.0
    loaded = taut.CableNet(
        built.nodes,
        net.supports,
        net.edges,
        net.axial_stiffness,
        built.unstressed_lengths,
        loads=loads,
    )
    under = taut.solve_equilibrium(loaded).form
    second = taut.read_survey(net, taut.simulate_survey(net, under, noise=0.5e-3, seed=9))
    both = taut.identify(net, survey, epochs=[(second, [], loads)], prior="uniform:3mm", draws=0)
    assert both.trust == "passed", both.findings
    assert both.epochs[1]["load"] == pytest.approx(200.0 * len(net.free_nodes[::4]))
    both.save(tmp_path / "both.json")
    assert json.loads((tmp_path / "both.json").read_text())["epochs"][1]["load"] > 0.0


def test_a_load_cell_that_some_priors_leave_out_is_named():
    net = taut.hypar(5, 5)
    form = taut.solve_equilibrium(taut.built_net(net, prior="uniform:3mm", seed=4)).form
    survey = taut.read_survey(net, taut.simulate_survey(net, form, noise=0.5e-3))
    with pytest.warns(UserWarning, match="check the unit"):
        found = taut.identify(net, survey, forces=[(0, 700.0, 50.0)])
    (outlier,) = found.force_outliers
    assert 0.0 < outlier["probability"] < 0.95
    assert found.trust == "doubtful"
    assert found.findings[0]["ids"] == ["0"]
