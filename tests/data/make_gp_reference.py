#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes gp_reference.json: Gaussian processes trained by scikit-learn, for tests/gp.

    /usr/bin/python3 tests/data/make_gp_reference.py

Made with Debian 12's python3-sklearn 1.2.1. Takes some 15 seconds. Each output is trained on its own
with a constant times RBF plus white kernel, wide bounds, no jitter, and the best of many starts.
"""

import json
import re
import warnings
from pathlib import Path

import numpy as np
import sklearn
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

RESTARTS = 40
TEST_POINTS = 6


def train(x, y):
    """Hyperparameters in our words, the negative log likelihood, and the regressor."""
    # In units of its own scale, an output's best hyperparameters lie well within these bounds.
    kernel = ConstantKernel(1.0, (1e-4, 1e8)) * RBF(1.0, (1e-2, 1e3)) + WhiteKernel(
        1e-2, (1e-12, 1e2)
    )
    regressor = GaussianProcessRegressor(
        kernel, alpha=0.0, n_restarts_optimizer=RESTARTS, random_state=1
    )
    regressor.fit(x, y)
    return regressor


def reference(name, x, outputs, at, input_unit, output_unit):
    """x (n x d), outputs (n x m) and at (k x d) are of the order of 1; scikit-learn sees them so, the
    file holds them times their units."""
    result = {
        "name": name,
        "inputs": (x * input_unit).tolist(),
        "outputs": (outputs * output_unit).T.tolist(),
        "test_inputs": (at * input_unit).tolist(),
        "processes": [],
    }
    for y in outputs.T:
        regressor = train(x, y)
        constant, length, white = np.exp(regressor.kernel_.theta)
        mean, std = regressor.predict(at, return_std=True)
        result["processes"].append(
            {
                "inverse_length_scale": 1.0 / (length * input_unit),
                "signal_std": np.sqrt(constant) * output_unit,
                "noise_std": np.sqrt(white) * output_unit,
                # A density per unit of the output: n log(unit) comes with the change of unit.
                "negative_log_likelihood": len(y) * np.log(output_unit)
                - regressor.log_marginal_likelihood_value_,
                "mean": (mean * output_unit).tolist(),
                # scikit-learn's is of a new observation; without its noise it is of the function.
                "std": (np.sqrt(np.maximum(std**2 - white, 0.0)) * output_unit).tolist(),
            }
        )
        print(name, regressor.kernel_, regressor.log_marginal_likelihood_value_)
    return result


def rounded(values):
    return np.round(values, 6)


def plane(rng):
    """Two inputs, as in a textbook: smooth, wavy, rough, and nothing but noise."""
    x, at = rounded(rng.uniform(-1, 1, (40, 2))), rounded(rng.uniform(-1, 1, (TEST_POINTS, 2)))
    noise = rng.normal(size=(40, 4))
    a, b = x.T
    outputs = np.column_stack(
        [
            np.exp(a - 0.5 * b) + 0.01 * noise[:, 0],
            np.sin(2.5 * a + b) * np.cos(2 * b) + 0.05 * noise[:, 1],
            np.sin(6 * a) + np.cos(5 * b + a) + 0.02 * noise[:, 2],
            noise[:, 3],
        ]
    )
    return reference("plane", x, rounded(outputs), at, 1.0, 1.0)


def nonlinear(rng):
    """Five inputs far from the origin, several kinds of nonlinearity."""
    shift = np.array([100.0, -50.0, 20.0, 0.0, 5.0])
    x, at = rng.normal(size=(60, 5)), rng.normal(size=(TEST_POINTS, 5))
    noise = rng.normal(size=(60, 4))
    outputs = np.column_stack(
        [
            np.tanh(x @ [1.0, 0.5, 0.0, -0.5, 0.2]) + 0.03 * noise[:, 0],
            x[:, 0] * x[:, 1] - 0.5 * x[:, 2] ** 2 + 0.2 * noise[:, 1],
            np.sin(2 * x[:, 0]) + 0.3 * x[:, 3] + 0.1 * noise[:, 2],
            x @ [0.3, -1.0, 0.2, 0.7, 0.1] + 0.5 * noise[:, 3],
        ]
    )
    return reference("nonlinear", rounded(x + shift), rounded(outputs), rounded(at + shift), 1.0, 1.0)


def nearly_linear(rng):
    """As a cable net: inputs and outputs of millimetres, nearly linear, very little noise."""
    x, at = rounded(rng.normal(size=(80, 12))), rounded(rng.normal(size=(TEST_POINTS, 12)))
    linear = rng.normal(size=(12, 5)) / np.sqrt(12)
    noise = rng.normal(size=(80, 5))
    bend = rng.normal(size=(12, 5)) / np.sqrt(12)
    strength = np.array([0.02, 0.1, 0.3, 0.05, 0.2])
    level = np.array([1e-3, 1e-3, 1e-2, 1e-1, 3e-3])
    outputs = x @ linear + strength * (x @ bend) ** 2 + level * noise
    return reference("nearly linear", x, rounded(outputs), at, 1e-3, 1e-3)


def main():
    warnings.simplefilter("ignore", ConvergenceWarning)
    rng = np.random.default_rng(1)
    data = {
        "scikit-learn": sklearn.__version__,
        "data_sets": [plane(rng), nonlinear(rng), nearly_linear(rng)],
    }
    path = Path(__file__).parent / "gp_reference.json"
    text = json.dumps(data, indent=1)
    rows = re.sub(r"\[[^][{}]*\]", lambda row: " ".join(row.group().split()), text)
    path.write_text(rows + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
