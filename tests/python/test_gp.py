# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a regressor that scikit-learn cannot use, or arrays of another shape."""

import pickle

import numpy as np
import pytest

pytest.importorskip("sklearn")

from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
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


def test_a_search_that_ends_early_says_so(data):
    inputs, outputs = data
    with pytest.warns(ConvergenceWarning, match="after max_spectra=6 decompositions"):
        early = MultiOutputGP(max_spectra=6).fit(inputs, outputs)
    assert early.n_iter_ == 6
    whole = MultiOutputGP().fit(inputs, outputs)
    assert 6 < whole.n_iter_ < 200
    assert (whole.log_marginal_likelihood_ >= early.log_marginal_likelihood_).all()


def test_covariances_are_those_of_the_standard_deviations(data):
    inputs, outputs = data
    at = inputs[:5] + 0.1
    model = MultiOutputGP().fit(inputs, outputs)
    _, covariance = model.predict(at, return_cov=True)
    assert covariance.shape == (5, 5, 3)
    std = model.predict(at, return_std=True)[1]
    assert np.sqrt(np.einsum("iim->im", covariance)) == pytest.approx(std, rel=1e-6, abs=1e-9)
    of_one = MultiOutputGP().fit(inputs, outputs[:, 0])
    assert of_one.predict(at, return_cov=True)[1].shape == (5, 5)


def test_noise_and_mean_are_those_of_scikit_learn(data):
    inputs, outputs = data
    at = np.array([[0.5, 0.5], [2.9, -2.9], [60.0, 60.0]])
    model = MultiOutputGP(normalize_y=False).fit(inputs, outputs + 100.0)
    ours = model.predict(at, return_std=True, include_noise=True)
    of_each = model.predict(at, return_cov=True, include_noise=True)[1]
    for k, kernel in enumerate(model.kernel_[:2]):
        theirs = GaussianProcessRegressor(kernel, optimizer=None).fit(inputs, outputs[:, k] + 100.0)
        mean, std = theirs.predict(at, return_std=True)  # of new observations, by the WhiteKernel
        assert ours[0][:, k] == pytest.approx(mean, abs=1e-4)
        assert ours[1][:, k] == pytest.approx(std, rel=1e-4)
        assert of_each[:, :, k] == pytest.approx(theirs.predict(at, return_cov=True)[1], abs=1e-4)
    assert ours[0][2] == pytest.approx([0.0, 0.0, 104.0], abs=1e-6)
    centred = MultiOutputGP().fit(inputs, outputs[:, 0] + 100.0)
    assert centred.predict(at)[2] == pytest.approx(100.0, abs=0.5)
    assert centred.kernel_.k1.k2.length_scale == centred.length_scale_[0]


def test_samples_have_the_mean_and_spread_that_are_predicted(data):
    model = MultiOutputGP().fit(*data)
    at = np.array([[0.5, 0.5], [2.9, -2.9], [6.0, 6.0]])
    mean, std = model.predict(at, return_std=True)
    draws = model.sample_y(at, n_samples=4000, random_state=3)
    assert draws.shape == (3, 3, 4000)
    assert draws.mean(axis=2) == pytest.approx(mean, abs=0.08 * std.max() + 1e-9)
    assert draws.std(axis=2) == pytest.approx(std, rel=0.06, abs=1e-9)
    assert np.array_equal(draws, model.sample_y(at, n_samples=4000, random_state=3))


@pytest.mark.parametrize("scale", [1e101, 1e-200])
def test_outputs_whose_squares_are_no_numbers_are_refused(data, scale):
    inputs, outputs = data
    with pytest.raises(ValueError, match="scale it"):
        MultiOutputGP().fit(inputs, np.column_stack([outputs[:, 0], scale * outputs[:, 0]]))


def test_it_works_in_a_pipeline(data):
    inputs, outputs = data
    scaled = make_pipeline(StandardScaler(), MultiOutputGP()).fit(inputs, outputs[:, :2])
    assert scaled.score(inputs, outputs[:, :2]) > 0.9


def test_low_rank_is_shown_and_pickled(data):
    inputs, outputs = data
    exact = MultiOutputGP().fit(inputs, outputs)
    assert (exact.approximation_error_ == 0.0).all()
    assert (exact.rank_, exact.left_out_) == (None, 0.0)
    ours = MultiOutputGP(most_decomposed=40, rank=25).fit(inputs, outputs)
    assert ours.rank_ == 25
    assert 0.001 < ours.left_out_ < 1.0
    # 25 directions cannot hold all of the second output: its error says so.
    assert ours.approximation_error_[1] > 0.01
    at = inputs + 0.1
    assert (pickle.loads(pickle.dumps(ours)).predict(at) == ours.predict(at)).all()
