# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a regressor that scikit-learn cannot use, or that finds less than its own."""

import pickle

import numpy as np
import pytest

pytest.importorskip("sklearn")

from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler
from sklearn.utils.estimator_checks import parametrize_with_checks
from taut.gp import MultiOutputGP


@parametrize_with_checks([MultiOutputGP()])
def test_it_is_an_estimator_of_scikit_learn(estimator, check):
    check(estimator)


@pytest.fixture(scope="module")
def data():
    random = np.random.default_rng(1)
    inputs = random.uniform(-3.0, 3.0, (60, 2))
    outputs = np.column_stack(
        [
            np.sin(inputs[:, 0]) + 0.05 * random.standard_normal(60),
            10.0 * np.cos(2.0 * inputs[:, 1]) + 0.5 * random.standard_normal(60),
            np.full(60, 4.0),
        ]
    )
    return inputs, outputs


def test_each_output_is_as_likely_as_scikit_learn_makes_it(data):
    inputs, outputs = data
    ours = MultiOutputGP(max_spectra=40).fit(inputs, outputs)
    for k in range(2):
        kernel = ConstantKernel(1.0, (1e-4, 1e4)) * RBF(1.0, (1e-2, 1e2)) + WhiteKernel(
            0.01, (1e-8, 1e2)
        )
        theirs = GaussianProcessRegressor(kernel, n_restarts_optimizer=3, random_state=0)
        theirs.fit(inputs, outputs[:, k] - outputs[:, k].mean())
        best = theirs.log_marginal_likelihood_value_
        assert ours.log_marginal_likelihood_[k] > best - 1e-2
        at = np.random.default_rng(2).uniform(-3.0, 3.0, (20, 2))
        mean, std = ours.predict(at, return_std=True)
        expected, with_noise = theirs.predict(at, return_std=True)
        latent = np.sqrt(with_noise**2 - theirs.kernel_.k2.noise_level)
        assert mean[:, k] - outputs[:, k].mean() == pytest.approx(expected, rel=2e-2, abs=5e-2)
        assert std[:, k] == pytest.approx(latent, rel=5e-2)


def test_a_constant_output_stays_constant(data):
    model = MultiOutputGP().fit(*data)
    mean, std = model.predict(np.zeros((2, 2)), return_std=True)
    assert np.all(mean[:, 2] == 4.0)
    assert np.all(std[:, 2] == 0.0)
    assert model.signal_std_[2] == 0.0


def test_draws_have_the_mean_and_spread_that_are_predicted(data):
    model = MultiOutputGP().fit(*data)
    at = np.array([[0.5, 0.5], [2.9, -2.9], [6.0, 6.0]])
    mean, std = model.predict(at, return_std=True)
    draws = model.sample_y(at, n_samples=4000, random_state=3)
    assert draws.shape == (3, 3, 4000)
    assert draws.mean(axis=2) == pytest.approx(mean, abs=0.08 * std.max() + 1e-9)
    assert draws.std(axis=2) == pytest.approx(std, rel=0.06, abs=1e-9)
    again = model.sample_y(at, n_samples=4000, random_state=3)
    assert np.array_equal(draws, again)


def test_it_is_pickled_with_what_it_learnt(data):
    model = MultiOutputGP().fit(*data)
    same = pickle.loads(pickle.dumps(model))
    at = np.array([[0.1, 0.2]])
    for ours, theirs in zip(
        model.predict(at, return_std=True), same.predict(at, return_std=True), strict=True
    ):
        assert np.array_equal(ours, theirs)


def test_it_works_in_a_pipeline(data):
    inputs, outputs = data
    scaled = make_pipeline(StandardScaler(), MultiOutputGP()).fit(inputs, outputs[:, :2])
    assert scaled.score(inputs, outputs[:, :2]) > 0.9


def test_by_low_rank_it_tells_its_error_and_is_no_surer_than_exact(data):
    inputs, outputs = data
    exact = MultiOutputGP().fit(inputs, outputs)
    ours = MultiOutputGP(most_decomposed=40, rank=25).fit(inputs, outputs)
    assert (exact.approximation_error_ == 0.0).all()
    assert (ours.approximation_error_[:2] > 0.0).all()
    assert (exact.rank_, exact.left_out_) == (None, 0.0)
    assert ours.rank_ == 25
    assert 0.001 < ours.left_out_ < 1.0
    at = np.random.default_rng(3).uniform(-3.0, 3.0, (30, 2))
    mean, std = ours.predict(at, return_std=True)
    expected, expected_std = exact.predict(at, return_std=True)
    assert mean[:, 0] == pytest.approx(expected[:, 0], abs=0.01)
    # What 25 directions cannot hold of the second, its error and its width tell.
    assert ours.approximation_error_[1] > 0.01
    assert (np.abs(mean - expected)[:, :2] < 3.0 * std[:, :2]).all()
    assert (std[:, :2].mean(axis=0) > expected_std[:, :2].mean(axis=0)).all()
    draws = ours.sample_y(at, n_samples=2000)
    assert draws.std(axis=2)[:, :2] == pytest.approx(std[:, :2], rel=0.1)
    assert (pickle.loads(pickle.dumps(ours)).predict(at) == mean).all()
