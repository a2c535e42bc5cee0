#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What a call from Python costs besides its work, and what importing costs.

python benchmarks/python_calls.py [--write docs/python.md]
"""

import argparse
import statistics
import subprocess
import sys
import timeit
from pathlib import Path

import numpy as np
import taut


def microseconds(call):
    """The best of several repetitions: the others waited for something else."""
    timer = timeit.Timer(call)
    count, _ = timer.autorange()
    return 1e6 * min(timer.repeat(5, count)) / count


def seconds_of(code):
    """The median of fresh interpreters, which time the code themselves."""
    timed = f"import time; t = time.perf_counter(); {code}; print(time.perf_counter() - t)"
    runs = [
        float(subprocess.run([sys.executable, "-c", timed], capture_output=True, check=True).stdout)
        for _ in range(7)
    ]
    return statistics.median(runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", type=Path, help="page whose table is replaced")
    told = parser.parse_args()
    net = taut.hypar(2, 2)
    form, lengths = np.array(net.nodes), np.array(net.unstressed_lengths)
    solver = taut.EquilibriumSolver(net)
    rows = [
        ("`net.nodes`, a view", microseconds(lambda: net.nodes)),
        ("`taut.edge_lengths(net, form)`", microseconds(lambda: taut.edge_lengths(net, form))),
        ("`solver.solve(lengths)`, in equilibrium", microseconds(lambda: solver.solve(lengths))),
    ]
    lines = ["| call, on a net of 4 free nodes | microseconds |", "|---|---|"]
    lines += [f"| {name} | {value:.2f} |" for name, value in rows]
    numpy, both = seconds_of("import numpy"), seconds_of("import taut")
    lines += ["", f"`import taut` takes {both:.3f} s, of which NumPy {numpy:.3f} s."]
    made = "\n".join(lines)
    print(made)
    if told.write:
        page = told.write.read_text(encoding="utf-8")
        begin, end = "<!-- by benchmarks/python_calls.py -->\n", "<!-- end -->"
        head, rest = page.split(begin)
        page = head + begin + "\n" + made + "\n\n" + end + rest.split(end, 1)[1]
        told.write.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
