#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Trains the Gaussian process of one edge with scikit-learn, to compare with `taut train`.

    taut sample net.json -n 1000 -o data.h5
    sklearn_one_output.py data.h5 --edge 0 --training 950

Prints one line of JSON: the seconds of the training (not of reading), the negative log likelihood
(of lengths in m, as taut reports it), the mean squared error on the samples left over [m^2], the
hyperparameters in SI units, the version of scikit-learn and the number of BLAS threads.

One start and no restarts: scikit-learn searches less than it would need to be sure of its optimum,
and is measured at its quickest. Inputs and outputs are scaled, and the start is where the optimum of a
nearly linear map is to be expected.
"""

import argparse
import json
import sys
import time
import warnings

import h5py
import numpy as np
import sklearn
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel


def blas_threads():
    """Of the BLAS that NumPy uses, None where threadpoolctl is not there to ask."""
    try:
        from threadpoolctl import threadpool_info
    except ImportError:
        return None
    return max((pool["num_threads"] for pool in threadpool_info()
                if pool["user_api"] == "blas"), default=None)


def median_distance(x, pairs=2000):
    """Of some pairs of rows."""
    rng = np.random.default_rng(1)
    i, j = rng.integers(len(x), size=(2, pairs))
    distances = np.linalg.norm(x[i] - x[j], axis=1)
    return np.median(distances[i != j])


def train(x, y):
    """x with median distance 1, y with standard deviation 1."""
    length = 30.0
    # A map that is linear over the data, seen as a piece of a wave of that length scale.
    kernel = ConstantKernel(length**2, (1e-3, 1e9)) * RBF(length, (1e-1, 1e4)) + WhiteKernel(
        1e-4, (1e-12, 1e1)
    )
    # The jitter must stay below the noise that is to be found.
    regressor = GaussianProcessRegressor(kernel, alpha=1e-12)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)
        start = time.perf_counter()
        regressor.fit(x, y)
        return regressor, time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data", help="HDF5 file of taut sample")
    parser.add_argument("--edge", type=int, default=0, help="column of length_deviation")
    parser.add_argument("--training", type=int, default=950, help="samples to train on, the first")
    arguments = parser.parse_args()
    with h5py.File(arguments.data, "r") as file:
        forms = file["form_deviation"][:]
        lengths = file["length_deviation"]
        if not 0 <= arguments.edge < lengths.shape[1]:
            sys.exit(f"--edge {arguments.edge}, expected 0 to {lengths.shape[1] - 1}")
        if not 2 <= arguments.training <= len(forms):
            sys.exit(f"--training {arguments.training}, expected 2 to {len(forms)}")
        y = lengths[:, arguments.edge]

    n = arguments.training
    input_unit, output_unit = median_distance(forms[:n]), np.std(y[:n])
    regressor, seconds = train(forms[:n] / input_unit, y[:n] / output_unit)
    constant, length, white = np.exp(regressor.kernel_.theta)
    result = {
        "seconds": seconds,
        "nlml": n * np.log(output_unit) - regressor.log_marginal_likelihood_value_,
        "mse_validation": None,
        "inverse_length_scale": 1.0 / (length * input_unit),
        "signal_std": np.sqrt(constant) * output_unit,
        "noise_std": np.sqrt(white) * output_unit,
        "sklearn": sklearn.__version__,
        "threads": blas_threads(),
    }
    if n < len(forms):
        error = regressor.predict(forms[n:] / input_unit) * output_unit - y[n:]
        result["mse_validation"] = np.mean(error**2)
    print(json.dumps(result))


if __name__ == "__main__":
    main()
