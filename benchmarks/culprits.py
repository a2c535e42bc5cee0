# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Whether the one thing that is wrong is named; prints docs/culprits.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/culprits.py > docs/culprits.md
"""

import json
import pathlib
import sys
import tempfile

import numpy as np
from coverage import Net, taut

TRIALS = 100
NOISE = 0.5e-3
# Baarda: of one test in 1,000 for all 128 edges a threshold of 21.3, found with a probability of 80 %.
LEAST = np.sqrt(21.3) + 0.84


def identified(net, folder, seed, alter, wrong_target=None):
    """Result of a survey of the net built otherwise, a tenth hidden."""
    net.alter = lambda deviations, nodes, random: alter(deviations, nodes)
    form, *_ = net.build("uniform:5mm", [], seed)
    random = np.random.default_rng(10_000 + seed)
    with (folder / "survey.csv").open("w") as out:
        for node in net.free:
            place = form[node] + NOISE * random.normal(size=3)
            if node == wrong_target:
                place = place + 0.01 * np.array([0.6, 0.0, 0.8])
            if random.random() >= 0.1 or node == wrong_target:
                out.write(f"{node}," + ",".join(map(repr, map(float, place))) + "\n")
    taut("identify", folder / "net.json", folder / "survey.csv", "--noise", "0.5mm", "--prior", "uniform:5mm", "--frame",
         "net", "--uncertain", "none", "--draws", "0", "--quiet", "-o", folder / "result.json")
    return json.loads((folder / "result.json").read_text())


def named(result):
    """All that is blamed, the largest statistic first: sets of names that cannot be told apart."""
    found = result["diagnostics"]
    blamed = [(entry["statistic"], {("edge", entry["edge"])}) for entry in found["length_outliers"]]
    for entry in found["boundary"]:
        kinds = ("edge", "support") if "edge" in entry else ("support", "edge")
        either = {(kinds[0], entry.get("edge", entry.get("node")))}
        if entry["confounded_with"] is not None:
            either.add((kinds[1], int(entry["confounded_with"])))
        blamed.append((entry["statistic"], either))
    blamed += [(o["statistic"], {("target", o["node"])}) for o in result["survey"]["outliers"]]
    return [names for _, names in sorted(blamed, key=lambda one: -one[0])]


def row(kind, net, folder, trials):
    random = np.random.default_rng(7)
    tried = first = innocent = 0
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

            probe = identified(net, folder, seed, turned(0.03))["diagnostics"]["boundary"]
            std = next((entry["std"] for entry in probe if entry.get("edge") == edge), None)
            if std is None:
                continue
            size = 2 * LEAST * std
            alter = turned(size * random.choice([-1, 1]))
        blamed = named(identified(net, folder, seed, alter, wrong_target))
        tried += 1
        sizes.append(size)
        first += bool(blamed) and culprit in blamed[0]
        innocent += sum(culprit not in names for names in blamed)
    return (f"| {kind} | {1e3 * np.min(sizes):.1f} to {1e3 * np.max(sizes):.1f} | {tried} of {trials} | {first} | {innocent} |")


def main():
    trials = int(sys.argv[1]) if len(sys.argv) > 1 else TRIALS
    print("# Is the culprit named?\n")
    print("Written by `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/culprits.py`: surveys of the built-in net (lengths")
    print("uniform:5mm, noise 0.5 mm, a tenth hidden), each with one thing that is wrong: a target 10 mm off, or an adjustable edge")
    print("off by twice its minimal detectable error, that is found with a probability of 80 % (its standard deviation from a")
    print("survey of the same net with the edge 30 mm off; *tried* counts those that this names, others do not show). *Named first*:")
    print("it has the largest statistic of all that is blamed, by itself or beside the rival that cannot be told from it; *sound ones*:")
    print("all else that is blamed, over all surveys.\n")
    print("| what is wrong | by [mm] | tried | named first | sound ones |")
    print("|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        net = Net("hilo-quarter", 1, folder)
        for kind in ("target", "adjustable edge"):
            print(row(kind, net, folder, trials), flush=True)


if __name__ == "__main__":
    main()
