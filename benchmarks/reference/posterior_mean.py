#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""How near `map` comes to the posterior mean, whose error no estimate beats: a table of docs/validation.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/reference/posterior_mean.py --write

The posterior mean is taken from Gibbs chains on the truncated normal

    p(d | y)  ~  [ |d_k| <= bound ]  exp(-|y - r - J (d - d_0)|^2 / (2 noise^2)),

r and J the form and its rates at a first estimate d_0, by code that shares nothing with taut
(posterior_chains.py beside it). The chains step along each length and along the eigenvectors of the
largest variances, so that lengths at a hidden node, known by their sum alone, mix too. Needs NumPy.
"""
import pathlib
import sys

import numpy as np
from posterior_chains import Net, r_hat

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from page_block import by, heading, show
from simulation import identify, taut, temporary_folder, write_points

BOUND = 0.005
CASES = [(noise, hidden) for noise in (1e-4, 5e-4, 2e-3) for hidden in (0.0, 0.1)]
SURVEYS = 2
CHAINS = 24
SWEEPS = 1000
WARM_UP = 200


GRID = np.linspace(-9.0, 9.0, 20_001)
CDF = np.cumsum(np.exp(-0.5 * GRID**2))  # of the standard normal, by a table: NumPy has no erf
CDF /= CDF[-1]


def truncated_normals(low, high, rng):
    """Of mean 0 and variance 1; where the interval lies beyond 5 standard deviations, by its exponential tail."""
    share = rng.random(low.shape)
    a, b = np.interp(low, GRID, CDF), np.interp(high, GRID, CDF)
    inner = np.interp(a + share * (b - a), CDF, GRID)
    side = np.where(low > 0.0, 1.0, -1.0)
    near, far = np.where(low > 0.0, low, -high), np.where(low > 0.0, high, -low)
    rate = np.maximum(near, 1.0)
    with np.errstate(over="ignore"):
        tail = near - np.log1p(-share * -np.expm1(-rate * (far - near))) / rate
    return np.clip(np.where(near > 5.0, side * tail, inner), low, high)


def chains(precision, mean, rng):
    """Draws (sweeps x chains x lengths) of the normal of this precision and mean, cut at the bounds."""
    count = len(mean)
    _, vectors = np.linalg.eigh(precision)
    wide = vectors.T[: count // 3]  # of the largest variances
    pushed, curvature = wide @ precision, np.einsum("ij,ij->i", wide @ precision, wide)
    own = np.diag(precision)
    d = np.clip(mean + 0.05 * BOUND * rng.standard_normal((CHAINS, count)), -BOUND, BOUND)
    kept = []
    for sweep in range(WARM_UP + SWEEPS):
        slope = (d - mean) @ precision

        def step_within(low, high, along, weight):
            std = weight**-0.5
            step = -along / weight
            step = step + std * truncated_normals((low - step) / std, (high - step) / std, rng)
            return np.clip(step, np.minimum(low, 0.0), np.maximum(high, 0.0))

        for k in rng.permutation(count):
            step = step_within(-BOUND - d[:, k], BOUND - d[:, k], slope[:, k], own[k])
            d[:, k] += step
            slope += step[:, None] * precision[k]
        for k in rng.permutation(len(wide)):
            sign = np.sign(wide[k])
            low = ((-sign * BOUND - d) / wide[k]).max(axis=1)
            high = ((sign * BOUND - d) / wide[k]).min(axis=1)
            step = step_within(low, high, slope @ wide[k], curvature[k])
            d = np.clip(d + step[:, None] * wide[k], -BOUND, BOUND)
            slope += step[:, None] * pushed[k]
        if sweep >= WARM_UP:
            kept.append(d.copy())
    return np.array(kept)


def identified(folder, net, y, seen, noise):
    write_points(folder / "survey.csv", seen, y[seen])
    result, _ = identify(folder, "--noise", f"{1e3 * noise:g}mm", "--prior", f"uniform:{1e3 * BOUND:g}mm", "--frame", "net", "--uncertain",
                         "none", "--draws", "0")
    return np.array([edge["length_deviation"] for edge in result["edges"]])


def try_survey(folder, net, noise, hidden, seed):
    rng = np.random.default_rng(seed)
    truth = rng.uniform(-BOUND, BOUND, len(net.interior))
    form, found = net.forms(truth[None], net.nodes[None])
    assert found.all()
    y = form[0].copy()
    y[net.free] += noise * rng.standard_normal((len(net.free), 3))
    keep = np.sort(rng.permutation(len(net.free))[round(hidden * len(net.free)) :])
    estimate = identified(folder, net, y, net.free[keep], noise)
    start, found = net.forms(estimate[None], form)
    assert found.all()
    rows = (3 * keep[:, None] + np.arange(3)).ravel()
    rates = net.rates(start[0], net.lengths(estimate[None])[0])[rows]
    gap = (y - start[0])[net.free].ravel()[rows]
    precision = rates.T @ rates / noise**2
    # Lengths that the survey does not tell at all would have no mean without a trace of precision.
    precision += 1e-9 * np.eye(len(estimate)) / BOUND**2
    mean = estimate + np.linalg.solve(precision, rates.T @ gap / noise**2)
    draws = chains(precision, mean, rng)
    return truth, estimate, draws.mean(axis=(0, 1)), draws.std(axis=(0, 1)), r_hat(draws)


def lines():
    yield by(__file__, f", {CHAINS} chains of {SWEEPS} sweeps, {SURVEYS} surveys a row")
    yield from heading("noise [mm] | hidden | MSE of map [m2] | of the chains' mean [m2] | above [%] | off, RMS | off, largest | R-hat")
    with temporary_folder() as folder:
        taut("example", "hilo-quarter", "-o", folder / "net.json")
        net = Net(folder / "net.json")
        for noise, hidden in CASES:
            tried = [try_survey(folder, net, noise, hidden, seed) for seed in range(SURVEYS)]
            truth, estimate, mean, std = (np.array([one[i] for one in tried]) for i in range(4))
            off = (estimate - mean) / std
            yield (
                f"| {1e3 * noise:g} | {100 * hidden:g} % | {np.mean((estimate - truth) ** 2):.3e} | "
                f"{np.mean((mean - truth) ** 2):.3e} | {100 * np.mean((estimate - mean) ** 2) / np.mean(std**2):.2f} | "
                f"{np.sqrt(np.mean(off**2)):.3f} | {np.abs(off).max():.2f} | {max(one[4] for one in tried):.3f} |"
            )


if __name__ == "__main__":
    show("validation.md", __file__, lines())
