# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how often the truth lies in the 95 % intervals of `taut identify`: the table of docs/validation.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/coverage.py --write
"""

import numpy as np
from page_block import by, heading, show
from simulation import Count, Net, identify, quantity, rms, temporary_folder, write_survey

UNKNOWNS = ["stiffness:5%", "supports:1mm", "temperature:15K", "adjustable:0.5mm", "loads:20N"]

# net, factor of its stiffness at the same tensions, prior, noise, hidden, surveys, uncertain, load cells
CASES = [
    ("hilo-quarter", 1, "uniform:5mm", "0.5mm", "10%", 50, [], 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, [], 0),
    ("hypar:9x9", 1, "normal:2mm", "2mm", "10%", 200, [], 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, UNKNOWNS, 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, [*UNKNOWNS, "stiffness-each:3%"], 5),
    ("hypar:9x9", 10, "uniform:0.5mm", "0.5mm", "10%", 100, [], 5),
    ("hypar:9x9", 10, "uniform:2mm", "0.5mm", "10%", 50, [], 5),
    ("hypar:9x9", 1, "uniform:15mm", "0.5mm", "10%", 20, [], 0),
    ("steel-roof", 1, "uniform:5mm", "0.5mm", "10%", 50, [], 0),
    ("steel-roof", 1, "uniform:2mm", "0.5mm", "10%", 50, [], 0),
]
CELL_NOISE = 0.02


def truth_of(parameter, truth):
    values = truth[parameter["name"]]
    if "edge" in parameter:
        return values[parameter["edge"]]
    if "node" in parameter:
        return values[parameter["node"]]["xyz".index(parameter["axis"])]
    return values


def row(case, folder):
    name, factor, prior, noise, hidden, surveys, uncertain, cells = case
    net = Net(name, folder, factor)
    lengths, slack, tensions, means, places, numbers = (Count() for _ in range(6))
    errors, failed = [], 0
    for seed in range(surveys):
        form, tension, deviations, truth = net.build(prior, uncertain, seed)
        random = np.random.default_rng(10_000 + seed)
        write_survey(folder / "survey.csv", net.free, lambda node: form[node] + quantity(noise) * random.normal(size=3), random,
                     quantity(hidden))
        words = ["--noise", noise, "--frame", "net", "--prior", prior]
        for parameter in ["none", *uncertain]:
            words += ["--uncertain", parameter]
        if cells:
            read = random.choice(np.flatnonzero(tension > 0), cells, replace=False)
            lines = [f"{e},{tension[e] * (1 + CELL_NOISE * random.normal())}\n" for e in read]
            (folder / "forces.csv").write_text("".join(lines))
            words += ["--forces", folder / "forces.csv", "--force-noise", f"{100 * CELL_NOISE:g}%"]
        result, ended = identify(folder, *words)
        failed += ended.returncode != 0
        if not result:
            continue
        for edge in result["edges"]:
            (slack if edge["status"] == "slack" else lengths).add(deviations[edge["edge"]], edge)
        for parameter in result["uncertain"]:
            numbers.add_estimate(truth_of(parameter, truth), parameter["mean"], parameter["std"])
        if not result["mean_tension"]:
            continue
        for edge in result["edges"] + result["adjustable_edges"]:
            tensions.add(tension[edge["edge"]], edge, "tension_")
        means.add(tension.mean(), result["mean_tension"])
        errors.append(result["mean_tension"]["mean"] / tension.mean() - 1)
        for place in result["missing_places"]:
            for axis in range(3):
                bounds = {"lower": place["lower"][axis], "upper": place["upper"][axis]}
                places.add(form[place["node"]][axis], bounds)
    error = f"{100 * rms(errors):.2f} %" if errors else "-"
    of_net = f"`{name}`" + (f", {factor} times as stiff" if factor != 1 else "")
    return (
        f"| {of_net} | {prior}, {noise}, {hidden} | {', '.join(uncertain) or 'none'} | {cells or 'none'} | "
        f"{surveys}, {failed}, {len(errors)} | {lengths} | {slack} | {tensions} | {places} | {numbers} | {means}, {error} |"
    )


def lines():
    yield by(__file__)
    yield from heading("net | prior, noise, hidden | uncertain | cells | surveys, failed, with tensions | lengths | slack | tensions | "
                       "places | parameters | mean tension, error")
    for case in CASES:
        with temporary_folder() as folder:
            yield row(case, folder)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
