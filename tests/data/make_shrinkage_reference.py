#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes shrinkage_reference.json: covariances of few samples after Schaefer & Strimmer (2005), for
tests/numerics.

    /usr/bin/python3 tests/data/make_shrinkage_reference.py

Made with Debian 12's python3-numpy 1.24.2. The equations of the paper are written out entry by entry
in exact fractions; NumPy only draws the samples, on a grid of 1/64, so that no rounding error hides
a factor.
"""

import json
import re
from fractions import Fraction
from pathlib import Path

import numpy as np


def shrunk(samples):
    """samples: d lists of n fractions. Returns the shrunk covariance and a."""
    d, n = len(samples), len(samples[0])
    means = [sum(row) / n for row in samples]
    x = [[value - mean for value in row] for row, mean in zip(samples, means)]
    s = [[None] * d for _ in range(d)]
    chance, squares = Fraction(0), Fraction(0)
    for i in range(d):
        for j in range(d):
            w = [x[i][k] * x[j][k] for k in range(n)]
            mean_w = sum(w) / n
            s[i][j] = Fraction(n, n - 1) * mean_w
            if i != j:
                chance += Fraction(n, (n - 1) ** 3) * sum((v - mean_w) ** 2 for v in w)
                squares += s[i][j] ** 2
    a = min(Fraction(1), chance / squares) if squares else Fraction(1)
    return [[s[i][j] * (1 if i == j else 1 - a) for j in range(d)] for i in range(d)], a


def case(name, rng, d, n, common):
    """Coordinates of unequal spreads that share one factor in the given measure."""
    factor = rng.standard_normal(n)
    values = [(1 + i) * (common * factor + rng.standard_normal(n)) for i in range(d)]
    samples = [[Fraction(round(64 * v), 64) for v in row] for row in values]
    covariance, a = shrunk(samples)
    print(f"{name}: a = {float(a):.4f}")
    return {
        "name": name,
        "samples": [[float(v) for v in row] for row in samples],
        "part": float(a),
        "covariance": [[float(v) for v in row] for row in covariance],
    }


def main():
    rng = np.random.default_rng(2005)
    cases = [
        case("correlated", rng, 5, 12, 1.5),
        case("few samples", rng, 6, 5, 0.5),
        case("many samples", rng, 3, 60, 1.0),
        case("chance alone", rng, 4, 8, 0.0),
    ]
    path = Path(__file__).with_name("shrinkage_reference.json")
    # One row of numbers a line.
    text = re.sub(r"\[\s+([-0-9][^\[\]]*?)\s+\]",
                  lambda m: "[" + re.sub(r"\s+", " ", m.group(1)) + "]",
                  json.dumps({"cases": cases}, indent=1))
    path.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
