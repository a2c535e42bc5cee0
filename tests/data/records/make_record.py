#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes plucked.csv, the record of a phone on a plucked cable, for tests and docs/site-workflow.md.

    /usr/bin/python3 tests/data/records/make_record.py

A string with bending stiffness between hinges, by finite differences, in two planes with different damping. It is
plucked every 6 s or so. The phone sits at a third of the length, where mode 3 has a node, samples at uneven times, and
sees noise, gravity and the hum of the mains. Prints the frequencies of the differences.
"""

from pathlib import Path

import numpy as np

LENGTH, MASS, TENSION, BENDING = 4.8, 0.62, 1500.0, 4.4  # m, kg/m, N, N m^2
DURATION, RATE = 36.0, 100.0  # s, Hz
POINTS = 400  # free ones of the string


def modes():
    """Natural frequencies [rad/s] and shapes of the string."""
    h = LENGTH / (POINTS + 1)
    second = (np.diag(np.full(POINTS, 2.0)) - np.diag(np.ones(POINTS - 1), 1) - np.diag(np.ones(POINTS - 1), -1)) / h**2
    squared, shapes = np.linalg.eigh((TENSION * second + BENDING * second @ second) / MASS)
    return np.sqrt(squared[:12]), shapes[:, :12]


def main():
    random = np.random.default_rng(3)
    omega, shapes = modes()
    print("f [Hz]:", (omega[:6] / (2 * np.pi)).round(4))
    steps = random.normal(1 / RATE, 0.05 / RATE, int(DURATION * RATE))
    time = np.cumsum(steps).round(5)
    sensor = shapes[round(POINTS / 3)]
    signals = random.normal(0, 0.02, (len(time), 3)) + [0.3, 0.1, 9.79]
    for axis, damping in ((1, 0.003), (2, 0.002)):
        for start in np.arange(0.5, DURATION, 6.0) + random.uniform(0, 3, 6):
            place = round(POINTS * random.uniform(0.1, 0.3))
            pluck = np.minimum(np.arange(POINTS) / place, (POINTS - np.arange(POINTS)) / (POINTS - place))
            size = random.uniform(0.2, 1.0) * 3e-4  # m
            since = np.maximum(time - start, 0)[:, None]
            moves = size * (shapes.T @ pluck) * sensor * -(omega**2) * (since > 0)
            signals[:, axis] += np.sum(moves * np.exp(-damping * omega * since) * np.cos(omega * since), axis=1)
    signals[:, 0] += 0.05 * np.sin(2 * np.pi * 33.3 * time)  # a fan
    size = np.linalg.norm(signals, axis=1)
    lines = ['"Time (s)","Acceleration x (m/s^2)","Acceleration y (m/s^2)","Acceleration z (m/s^2)","Absolute acceleration (m/s^2)"']
    lines += [f"{t:.5f},{x:.3f},{y:.3f},{z:.3f},{a:.3f}" for t, (x, y, z), a in zip(time, signals, size)]
    Path(__file__).with_name("plucked.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
