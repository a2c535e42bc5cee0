#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Natural frequencies of cables with bending stiffness, by finite elements: vibration_reference.json.

Euler-Bernoulli beams under tension in 400 Hermite elements, consistent mass. Nothing here knows the
characteristic equation that taut solves. Needs NumPy and SciPy.
"""
import json
import pathlib

import numpy as np
import scipy.linalg

ELEMENTS = 400


def frequencies(length, mass, bending_stiffness, tension, ends, count=3):
    h = length / ELEMENTS
    bending = np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
                        [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]]) / h**3
    geometric = np.array([[36, 3 * h, -36, 3 * h], [3 * h, 4 * h**2, -3 * h, -(h**2)],
                          [-36, -3 * h, 36, -3 * h], [3 * h, -(h**2), -3 * h, 4 * h**2]]) / (30 * h)
    inertia = np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
                        [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]]) * h / 420
    size = 2 * (ELEMENTS + 1)
    K, M = np.zeros((size, size)), np.zeros((size, size))
    for e in range(ELEMENTS):
        at = slice(2 * e, 2 * e + 4)
        K[at, at] += bending_stiffness * bending + tension * geometric
        M[at, at] += mass * inertia
    held = [0, size - 2] if ends == "hinged" else [0, 1, size - 2, size - 1]
    free = np.setdiff1d(np.arange(size), held)
    squares = scipy.linalg.eigh(K[np.ix_(free, free)], M[np.ix_(free, free)], eigvals_only=True,
                                subset_by_index=[0, count - 1])
    return np.sqrt(squares) / (2 * np.pi)


def main():
    cables = []
    for length, mass, bending_stiffness, tension in [(3.0, 0.6, 20.0, 15e3), (0.4, 0.05, 0.5, 800.0),
                                                     (12.0, 4.0, 3e3, 6e4)]:
        for ends in ("hinged", "fixed"):
            found = frequencies(length, mass, bending_stiffness, tension, ends)
            cables += [{"length": length, "mass": mass, "bending_stiffness": bending_stiffness, "ends": ends,
                        "mode": mode + 1, "frequency": float(f), "tension": tension}
                       for mode, f in enumerate(found)]
    path = pathlib.Path(__file__).parent / "vibration_reference.json"
    path.write_text(json.dumps({"cables": cables}, indent=1) + "\n")


if __name__ == "__main__":
    main()
