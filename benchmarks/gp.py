#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Time, memory and likelihood of taut.gp.MultiOutputGP beside those of other libraries.

The same inputs and outputs for all: forms and lengths of the built-in net. Each fits one process an
output, with constant mean, an isotropic squared exponential kernel and noise, all three
hyperparameters of each output by maximum marginal likelihood; each in a process of its own, on the
same number of threads. Libraries that are not installed are left out, and named.

    pip install '.[gp]' GPy gpytorch
    python benchmarks/gp.py [--samples 300] [--outputs 64] [--write]
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import time

import numpy as np
from page_block import show

NAMES = ["taut", "scikit-learn", "GPyTorch", "GPy"]


def data(samples, outputs):
    import taut

    drawn = taut.Sampler(taut.hilo_quarter(), "uniform:5mm", seed=1).draw(samples)
    inputs = np.array(drawn.form_deviations)
    chosen = np.linspace(0, drawn.length_deviations.shape[1] - 1, outputs).astype(int)
    lengths = np.array(drawn.length_deviations)[:, chosen]
    return inputs / inputs.std(), (lengths - lengths.mean(axis=0)) / lengths.std(axis=0)


def log_likelihood(inputs, output, length_scale, signal_var, noise_var):
    """Of one output, by the textbook's formula: the same judge for all."""
    squared = ((inputs**2).sum(1)[:, None] + (inputs**2).sum(1) - 2 * inputs @ inputs.T).clip(0)
    kernel = signal_var * np.exp(-0.5 * squared / length_scale**2)
    factor = np.linalg.cholesky(kernel + noise_var * np.eye(len(inputs)))
    solved = np.linalg.solve(factor, output)
    return (
        -0.5 * solved @ solved
        - np.log(np.diag(factor)).sum()
        - 0.5 * len(output) * np.log(2 * np.pi)
    )


def fit_taut(inputs, outputs):
    from taut.gp import MultiOutputGP

    model = MultiOutputGP().fit(inputs, outputs)
    return model.length_scale_, model.signal_std_**2, model.noise_std_**2


def fit_scikit_learn(inputs, outputs):
    from sklearn.gaussian_process import GaussianProcessRegressor
    from sklearn.gaussian_process.kernels import RBF, ConstantKernel, WhiteKernel

    start = float(np.sqrt(inputs.shape[1]))
    found = []
    for output in outputs.T:
        kernel = ConstantKernel(1.0, (1e-4, 1e6)) * RBF(start, (1e-2, 1e5)) + WhiteKernel(
            1e-2, (1e-8, 1e2)
        )
        kernel = GaussianProcessRegressor(kernel).fit(inputs, output).kernel_
        found.append(
            (kernel.k1.k2.length_scale, kernel.k1.k1.constant_value, kernel.k2.noise_level)
        )
    return np.array(found).T


def fit_gpy(inputs, outputs):
    import GPy

    found = []
    for output in outputs.T:
        kernel = GPy.kern.RBF(inputs.shape[1], lengthscale=float(np.sqrt(inputs.shape[1])))
        model = GPy.models.GPRegression(inputs, output[:, None], kernel, noise_var=1e-2)
        model.optimize()
        theta = (kernel.lengthscale, kernel.variance, model.likelihood.variance)
        found.append([float(value[0]) for value in theta])
    return np.array(found).T


def fit_gpytorch(inputs, outputs):
    """A batch of independent processes, as GPyTorch's documentation shows it, by Adam."""
    import gpytorch
    import torch

    count = outputs.shape[1]
    batch = torch.Size([count])

    class Model(gpytorch.models.ExactGP):
        def __init__(self, x, y, likelihood):
            super().__init__(x, y, likelihood)
            self.mean_module = gpytorch.means.ZeroMean(batch_shape=batch)
            self.covar_module = gpytorch.kernels.ScaleKernel(
                gpytorch.kernels.RBFKernel(batch_shape=batch), batch_shape=batch
            )

        def forward(self, x):
            return gpytorch.distributions.MultivariateNormal(
                self.mean_module(x), self.covar_module(x)
            )

    x = torch.tensor(inputs).expand(count, *inputs.shape)
    y = torch.tensor(outputs.T.copy())
    likelihood = gpytorch.likelihoods.GaussianLikelihood(
        batch_shape=batch, noise_constraint=gpytorch.constraints.GreaterThan(1e-8)
    ).double()
    model = Model(x, y, likelihood).double()
    model.covar_module.base_kernel.lengthscale = float(np.sqrt(inputs.shape[1]))
    likelihood.noise = 1e-2
    model.train(), likelihood.train()
    objective = gpytorch.mlls.ExactMarginalLogLikelihood(likelihood, model)
    optimizer = torch.optim.Adam(model.parameters(), lr=0.1)
    with gpytorch.settings.fast_computations(False, False, False):
        for _ in range(200):
            optimizer.zero_grad()
            loss = -objective(model(x), y).sum()
            loss.backward()
            optimizer.step()
    kernel = model.covar_module
    return tuple(
        values.detach().numpy().ravel()
        for values in (kernel.base_kernel.lengthscale, kernel.outputscale, likelihood.noise)
    )


FITS = {
    "taut": fit_taut,
    "scikit-learn": fit_scikit_learn,
    "GPyTorch": fit_gpytorch,
    "GPy": fit_gpy,
}


def run_one(name, samples, outputs):
    inputs, lengths = data(samples, outputs)
    FITS[name](inputs[:20], lengths[:20, :2])  # imports, and what is compiled when first used
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.perf_counter()
    found = FITS[name](inputs, lengths)
    seconds = time.perf_counter() - start
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    reached = [
        log_likelihood(inputs, output, *theta)
        for output, theta in zip(lengths.T, np.array(found).T, strict=True)
    ]
    return {
        "seconds": seconds,
        "mebibytes": (peak - before) / 1024,
        "log_likelihood": float(np.mean(reached)),
    }


def table(rows, samples, outputs):
    lines = [
        "| | seconds | of taut | memory [MiB] | mean log likelihood |",
        "|---|---|---|---|---|",
    ]
    for name, row in rows.items():
        if row is None:
            lines.append(f"| {name} | not installed here | | | |")
            continue
        ratio = row["seconds"] / rows["taut"]["seconds"]
        lines.append(
            f"| {name} | {row['seconds']:.2f} | {ratio:.1f} | {row['mebibytes']:.0f} "
            f"| {row['log_likelihood']:.2f} |"
        )
    return (
        f"{outputs} outputs, {samples} samples of {900} inputs, {os.cpu_count()} cores, by "
        f"`python benchmarks/gp.py --samples {samples} --outputs {outputs} --write`:\n\n" + "\n".join(lines)
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=300)
    parser.add_argument("--outputs", type=int, default=64)
    parser.add_argument("--write", action="store_true", help="put the table into docs/performance.md")
    parser.add_argument("--one", choices=NAMES, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.one:
        print(json.dumps(run_one(arguments.one, arguments.samples, arguments.outputs)))
        return
    rows = {}
    sizes = ["--samples", str(arguments.samples), "--outputs", str(arguments.outputs)]
    for name in NAMES:
        done = subprocess.run(
            [sys.executable, __file__, "--one", name, *sizes], capture_output=True, text=True
        )
        if "ModuleNotFoundError" in done.stderr:
            rows[name] = None
        elif done.returncode:
            raise SystemExit(f"{name} failed:\n{done.stderr}")
        else:
            rows[name] = json.loads(done.stdout.splitlines()[-1])
    show("performance.md", __file__, [table(rows, arguments.samples, arguments.outputs)])


if __name__ == "__main__":
    main()
