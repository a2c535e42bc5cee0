#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What a call from Python costs besides its work, beside the same call in C++, and what importing
costs.

python benchmarks/python_calls.py [--peer build/release/benchmarks/identify_points]
    [--write]
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
import timeit
from pathlib import Path

import numpy as np
import taut
from page_block import heading, show


def microseconds(call):
    """The best of several repetitions: the others waited for something else."""
    timer = timeit.Timer(call)
    count, _ = timer.autorange()
    return 1e6 * min(timer.repeat(5, count)) / count


def seconds_of(*codes):
    """The median of fresh interpreters for each code, in turns; they time it themselves."""

    def once(code):
        timed = f"import time; t = time.perf_counter(); {code}; print(time.perf_counter() - t)"
        command = [sys.executable, "-c", timed]
        return float(subprocess.run(command, capture_output=True, check=True).stdout)

    rounds = [[once(code) for code in codes] for _ in range(9)]
    return (statistics.median(column) for column in zip(*rounds, strict=True))


def identification(peer, repetitions=15):
    """Milliseconds of identifying the built-in net from points, here and in C++: the same call, in
    turns, the least of each; that lengths are the same is checked."""
    net = taut.hilo_quarter()
    form = taut.solve_equilibrium(taut.built_net(net, seed=7)).form
    columns = taut.simulate_survey(net, form, noise=0.5e-3, seed=1)
    ids = columns["id"]
    points = np.column_stack([columns[axis] for axis in "xyz"])

    def here():
        start = time.perf_counter()
        survey = taut.read_survey(net, points, ids=ids, noise=0.5e-3)
        found = taut.identify(net, survey)
        return time.perf_counter() - start, float(sum(found.length_deviation))

    with tempfile.TemporaryDirectory() as folder:
        net.save(f"{folder}/net.json")
        rows = zip(ids, points.tolist(), strict=True)
        lines = [f"{name} {x!r} {y!r} {z!r}" for name, (x, y, z) in rows]
        Path(f"{folder}/points.txt").write_text("\n".join(lines) + "\n")
        command = [peer, f"{folder}/net.json", f"{folder}/points.txt", "0.0005"]
        with subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        ) as there:
            seconds = []
            for _ in range(repetitions):
                ours, our_sum = here()
                there.stdin.write("\n")
                there.stdin.flush()
                theirs, their_sum = map(float, there.stdout.readline().split())
                if our_sum != their_sum:
                    sys.exit(f"lengths differ: their sums are {our_sum!r} and {their_sum!r}")
                seconds.append((ours, theirs))
            there.stdin.close()
    return (1e3 * min(column) for column in zip(*seconds, strict=True))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer", type=Path, help="program to compare identify() with")
    parser.add_argument("--write", action="store_true", help="put the table into docs/performance.md")
    arguments = parser.parse_args()
    if arguments.write and not arguments.peer:
        parser.error("--write takes --peer, too")
    net = taut.hypar(2, 2)
    form, lengths = np.array(net.nodes), np.array(net.unstressed_lengths)
    solver = taut.EquilibriumSolver(net)
    rows = [
        ("`net.nodes`, a view", microseconds(lambda: net.nodes)),
        ("`taut.edge_lengths(net, form)`", microseconds(lambda: taut.edge_lengths(net, form))),
        ("`solver.solve(lengths)`, in equilibrium", microseconds(lambda: solver.solve(lengths))),
    ]
    lines = [*heading("call, on a net of 4 free nodes | microseconds")]
    lines += [f"| {name} | {value:.2f} |" for name, value in rows]
    if arguments.peer:
        python, cpp = identification(arguments.peer)
        lines += [
            "",
            "`taut.identify(net, taut.read_survey(net, points, ids=ids, noise=0.5e-3))` of the "
            f"built-in net takes {python:.0f} ms, the same in C++ {cpp:.0f} ms: "
            f"{python / cpp:.2f} times.",
        ]
    numpy, both = seconds_of("import numpy", "import taut")
    lines += ["", f"`import taut` takes {both:.3f} s, of which NumPy {numpy:.3f} s."]
    show("performance.md", __file__, lines)


if __name__ == "__main__":
    main()
