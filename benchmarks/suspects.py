# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Whether the one thing that is wrong is named: a table of docs/diagnostics.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/suspects.py --write
"""

import numpy as np
from page_block import by, count_given, heading, show
from simulation import Net, either_of, identify, temporary_folder, write_survey

TRIALS = 100
MUCH_TOO_SHORT = "adjustable edge of hypar:9x9 too short, default call"
NOISE = 0.5e-3
# Baarda: of one test in 1,000 for all 128 edges a threshold of 21.3, found with a probability of 80 %.
LEAST = np.sqrt(21.3) + 0.84


def identified(net, folder, seed, alter, words, wrong_target=None):
    """Result of a survey of the net built otherwise, a tenth hidden."""
    net.alter = lambda deviations, nodes, random: alter(deviations, nodes)
    form, *_ = net.build("uniform:5mm", [], seed)
    random = np.random.default_rng(10_000 + seed)
    off = 0.01 * np.array([0.6, 0.0, 0.8])
    write_survey(folder / "survey.csv", net.free,
                 lambda node: form[node] + NOISE * random.normal(size=3) + (off if node == wrong_target else 0), random, shown=wrong_target)
    return identify(folder, "--noise", "0.5mm", "--prior", "uniform:5mm", *words, "--draws", "0")[0]


def named(result):
    """All suspects, the largest statistic first: sets of names that are confounded with each other."""
    found = result["diagnostics"]
    named = [(entry["statistic"], {("edge", entry["edge"])}) for entry in found["length_outliers"]]
    named += [(entry["statistic"], either_of(entry)) for entry in found["boundary"]]
    named += [(o["statistic"], {("target", o["node"])}) for o in result["survey"]["outliers"]]
    return [names for _, names in sorted(named, key=lambda one: -one[0])]


def row(kind, net, folder, trials):
    words = [] if kind == MUCH_TOO_SHORT else ["--frame", "net", "--uncertain", "none"]
    random = np.random.default_rng(7)
    tried = first = false_alarms = 0
    sizes = []
    for seed in range(trials):
        wrong_target = None
        if kind == "target":
            wrong_target = int(random.choice(net.free))
            culprit, size, alter = ("target", wrong_target), 0.01, lambda deviations, nodes: None
        else:
            edge = int(random.choice(net.adjustable))
            culprit = ("edge", edge)

            def turned(by, edge=edge):
                def alter(deviations, nodes):
                    deviations[edge] = by
                return alter

            if kind == MUCH_TOO_SHORT:
                size, alter = 0.015, turned(-0.015)
            else:
                probe = identified(net, folder, seed, turned(0.03), words)["diagnostics"]["boundary"]
                std = next((entry["std"] for entry in probe if entry.get("edge") == edge), None)
                if std is None:
                    continue
                size = 2 * LEAST * std
                alter = turned(size * random.choice([-1, 1]))
        accused = named(identified(net, folder, seed, alter, words, wrong_target))
        tried += 1
        sizes.append(size)
        first += bool(accused) and culprit in accused[0]
        false_alarms += sum(culprit not in names for names in accused)
    return (f"| {kind} | {1e3 * np.min(sizes):.1f} to {1e3 * np.max(sizes):.1f} | {tried} of {trials} | {first} | {false_alarms} |")


def lines():
    trials = count_given(TRIALS)
    yield by(__file__)
    yield from heading("what is wrong | by [mm] | tried | named first | false alarms")
    with temporary_folder() as folder:
        net = Net("hilo-quarter", folder)
        for kind in ("target", "adjustable edge"):
            yield row(kind, net, folder, trials)
        yield row(MUCH_TOO_SHORT, Net("hypar:9x9", folder), folder, trials)


if __name__ == "__main__":
    show("diagnostics.md", __file__, lines())
