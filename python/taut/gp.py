# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Gaussian processes for many outputs over the same inputs, as a scikit-learn regressor.

Hundreds of outputs, each with hyperparameters of its own, at the cost of a dozen decompositions of
the kernel matrix that all share. The best noise and signal of an output follow from one
decomposition, so that each length scale costs one.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut, calls
from taut._taut import FittedProcesses

try:
    from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel
    from sklearn.utils import check_random_state
    from sklearn.utils.validation import check_is_fitted, validate_data
except ImportError as _error:
    raise ImportError("taut.gp needs scikit-learn 1.6 or later: pip install 'taut[gp]'") from _error

if TYPE_CHECKING:
    from taut._taut import _fit_processes as fit
else:
    fit = calls.naming_arguments(_taut._fit_processes, "fit")

__all__ = ["FittedProcesses", "MultiOutputGP", "fit"]


class MultiOutputGP(MultiOutputMixin, RegressorMixin, BaseEstimator):
    """One process an output, with an isotropic squared exponential kernel and noise.

    Inputs are not scaled: scale features of different kinds first, by a StandardScaler say. Before
    fit() there are no hyperparameters, so that predict() raises NotFittedError and gives no prior.

    Args:
        relative_tolerance: the search for length scales ends when no output is expected to gain
            more than this, relative to its log likelihood.
        max_spectra: decompositions that all outputs share, at most. Each takes O(n^3). Where they
            end the search a ConvergenceWarning says so.
        most_decomposed: samples that are decomposed, at most. With more of them processes are
            fitted by low rank, in O(n^2 rank) and without any n x n matrix, with length scales
            found from so many samples, or 2000.
        rank: directions of the kernel matrix that are then kept, at most.
        normalize_y: subtract the mean of each output first; False: processes have the mean 0. The
            scale of an output needs none, since its signal and noise are estimated.

    Attributes:
        length_scale_, signal_std_, noise_std_: hyperparameters of each output (m,); 0 where an
            output is constant. The kernel is signal_std^2 exp(-|x - x'|^2 / (2 length_scale^2)).
        kernel_: the same as a kernel of scikit-learn, noise included; of y (n, m) a list of them.
        log_marginal_likelihood_: of each output (m,).
        n_iter_: decompositions that were made.
        leave_one_out_rmse_: of each output (m,), of predictions at each input, trained without it.
        rank_: directions that were kept; None where samples were decomposed.
        left_out_: part of the kernel matrix, of its trace, that they leave out. Where it is larger
            than that of the noise, signal counts as noise: the rank is too low.
        approximation_error_: by low rank, bound of what each output's mean is off from the exact
            one with the same hyperparameters, root mean square over the training inputs; else 0
            (m,). Standard deviations and leave-one-out errors contain it.
    """

    length_scale_: NDArray[np.float64]
    signal_std_: NDArray[np.float64]
    noise_std_: NDArray[np.float64]
    log_marginal_likelihood_: NDArray[np.float64]
    n_iter_: int
    leave_one_out_rmse_: NDArray[np.float64]
    rank_: int | None
    left_out_: float
    approximation_error_: NDArray[np.float64]

    def __init__(
        self,
        relative_tolerance: float = 1e-7,
        max_spectra: int = 200,
        most_decomposed: int = 3000,
        rank: int = 1500,
        normalize_y: bool = True,
    ):
        self.relative_tolerance = relative_tolerance
        self.max_spectra = max_spectra
        self.most_decomposed = most_decomposed
        self.rank = rank
        self.normalize_y = normalize_y

    def fit(self, X: ArrayLike, y: ArrayLike) -> MultiOutputGP:
        """Estimates hyperparameters by maximum marginal likelihood: X (n, d), y (n,) or (n, m)."""
        inputs, targets = validate_data(
            self, X, y, multi_output=True, y_numeric=True, dtype=np.float64, ensure_min_samples=2
        )
        self._is_flat = targets.ndim == 1
        outputs = np.asarray(targets, dtype=np.float64).reshape(len(inputs), -1)
        largest = np.abs(outputs).max(axis=0)
        spread = np.ptp(outputs, axis=0)
        # Squares must neither overflow nor vanish.
        wrong = np.flatnonzero((largest > 1e100) | ((spread > 0.0) & (spread < 1e-100)))
        if wrong.size:
            raise ValueError(
                f"y: output {wrong[0]} has numbers up to {largest[wrong[0]]:.3g} that differ by "
                f"{spread[wrong[0]]:.3g}, expected at most 1e100 and at least 1e-100: scale it"
            )
        is_constant = spread == 0.0
        self._mean = np.where(self.normalize_y | is_constant, outputs.mean(axis=0), 0.0)
        self._processes = fit(
            inputs,
            outputs - self._mean,
            relative_tolerance=self.relative_tolerance,
            max_spectra=self.max_spectra,
            most_decomposed=self.most_decomposed,
            rank=self.rank,
        )
        self.n_iter_ = self._processes.decompositions
        if not self._processes.is_converged:
            warnings.warn(
                f"the search for length scales ended after max_spectra={self.max_spectra} "
                "decompositions, where outputs could still gain likelihood",
                ConvergenceWarning,
                stacklevel=2,
            )
        with np.errstate(divide="ignore"):
            scale = 1.0 / self._processes.inverse_length_scale
        self.length_scale_ = np.where(np.isfinite(scale), scale, 0.0)
        self.signal_std_ = self._processes.signal_std
        self.noise_std_ = self._processes.noise_std
        self.log_marginal_likelihood_ = -self._processes.negative_log_likelihood
        self.leave_one_out_rmse_ = self._processes.leave_one_out_rmse
        self.rank_ = self._processes.rank
        self.left_out_ = self._processes.left_out
        self.approximation_error_ = self._processes.approximation_error
        return self

    @property
    def kernel_(self) -> Any:
        """The kernel of each output."""
        check_is_fitted(self)
        kernels = [
            ConstantKernel(signal**2) * RBF(scale or 1.0) + WhiteKernel(noise**2)
            for scale, signal, noise in zip(self.length_scale_, self.signal_std_, self.noise_std_)
        ]
        return kernels[0] if self._is_flat else kernels

    def _inputs(self, X: ArrayLike) -> Any:
        check_is_fitted(self)
        return validate_data(self, X, reset=False, dtype=np.float64)

    def _shaped(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        return values[:, 0] if self._is_flat else values

    def predict(
        self,
        X: ArrayLike,
        return_std: bool = False,
        return_cov: bool = False,
        include_noise: bool = False,
    ) -> Any:
        """Mean at X (k, d): (k,) or (k, m), of the latent function.

        With its standard deviation in the same shape, or its covariance (k, k) or (k, k, m); with
        include_noise those of new observations.
        """
        if return_std and return_cov:
            raise RuntimeError("expected at most one of return_std and return_cov")
        inputs = self._inputs(X)
        mean, std = self._processes.predict(inputs)
        mean = self._shaped(mean + self._mean)
        noise = self.noise_std_ if include_noise else np.zeros(len(self._mean))
        if return_cov:
            of_each = [
                self._processes.covariance(k, inputs) + noise[k] ** 2 * np.eye(len(inputs))
                for k in range(len(noise))
            ]
            return mean, of_each[0] if self._is_flat else np.stack(of_each, axis=-1)
        return (mean, self._shaped(np.hypot(std, noise))) if return_std else mean

    def sample_y(
        self, X: ArrayLike, n_samples: int = 1, random_state: Any = 0
    ) -> NDArray[np.float64]:
        """Samples of the latent functions: (k, n_samples), or (k, m, n_samples)."""
        inputs = self._inputs(X)
        random = check_random_state(random_state)
        mean, _ = self._processes.predict(inputs)
        draws = np.empty((*mean.shape, n_samples))
        for output in range(mean.shape[1]):
            covariance = self._processes.covariance(output, inputs)
            values, vectors = np.linalg.eigh(covariance)
            root = vectors * np.sqrt(np.clip(values, 0.0, None))
            draws[:, output] = (mean[:, output] + self._mean[output])[:, None] + root @ (
                random.standard_normal((len(values), n_samples))
            )
        return draws[:, 0] if self._is_flat else draws
