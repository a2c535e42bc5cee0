# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What the tests of the Python package share: one net, as built, surveyed and identified."""

import numpy as np
import pytest
import taut


@pytest.fixture(scope="session")
def net():
    return taut.hypar(5, 5)


@pytest.fixture(scope="session")
def built(net):
    return taut.built_net(net, prior="uniform:3mm", seed=2)


@pytest.fixture(scope="session")
def form(built):
    """The form that the net takes as built."""
    return taut.solve_equilibrium(built).form


@pytest.fixture(scope="session")
def deviations(net, built):
    edges = net.interior_edges
    return built.unstressed_lengths[edges] - net.unstressed_lengths[edges]


@pytest.fixture(scope="session")
def columns(net, form):
    """What an instrument reads of the net as built, with half a millimetre of noise."""
    return taut.simulate_survey(net, form, noise=0.5e-3, seed=3)


@pytest.fixture(scope="session")
def survey(net, columns):
    return taut.read_survey(net, columns)


@pytest.fixture(scope="session")
def found(net, survey):
    return taut.identify(net, survey, prior="uniform:3mm", draws=100)


@pytest.fixture
def positions(net, form):
    """The free nodes as built, without noise (n_I, 3)."""
    return np.array(form)[net.free_nodes]
