# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well tensions are known by each kind of evidence, where the stiffness is wrong: a table of docs/validation.md.

All cables are stiffer or softer than designed by one factor, uniform within 10 %, of which `taut identify` assumes 5 % by
default. It also assumes what else is drawn here: 2 % of each stiffness, 5 K, supports off by 1 mm, turnbuckles by 0.5 mm,
3 % of the mass, 1 % of all load cells, 2 % of loads. Cables vibrate as strings with bending, by the series of Morse for fixed
ends, and sag as parabolas. A weighed cable has its mass per length known to 0.5 %.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/evidence.py --write
"""

import collections
import json

import numpy as np
from page_block import by, heading, show
from simulation import Count, Net, identify, quantity, read_form, rms, taut, temporary_folder, verdict_counts, write_points

EVIDENCE = {
    "form": [],
    "5 cells": ["cells"],
    "5 frequencies": ["frequencies"],
    "5 frequencies, weighed cable": ["frequencies", "weighed"],
    "5 frequencies, weighed cable, ends known": ["of hinged", "weighed"],
    "5 sags": ["sags"],
    "a load": ["load"],
    "all": ["cells", "frequencies", "load"],
}
EVERY = [evidence for evidence in EVIDENCE if evidence != "5 sags"]

# kind, net, its size, factor of its stiffness at the same tensions, prior, noise, error of a free length, surveys, kinds of evidence.
# Cables of the long net are 13 m long and sag by 8 mm, those of the others by less than half a millimetre.
CASES = [
    ("soft", "hypar:9x9", 10, 1, "uniform:5mm", "0.5mm", "5mm", 50, EVERY),
    ("stiff", "hypar:9x9", 10, 5, "uniform:2mm", "0.5mm", "5mm", 50, EVERY),
    ("long", "hypar:9x9", 100, 20, "uniform:20mm", "1mm", "10mm", 50, EVERY + ["5 sags"]),
    ("steel roof", "steel-roof", 1, 1, "uniform:2mm", "0.5mm", "5mm", 50, ["form", "5 frequencies", "5 frequencies, weighed cable, ends known"]),
]
SITE = ["stiffness-each:2%", "temperature:5K", "supports:1mm", "adjustable:0.5mm"]
STEEL, ELASTICITY, GRAVITY = 7850.0, 2e11, 9.80665
MEASURED = 5
SAG_POINT = 0.5e-3  # standard deviation of a surveyed point of a cable


def of_size(net, size):
    """Makes a net larger, of cables with the mass of steel rods."""
    data = net.data
    net.nodes, net.lengths = size * net.nodes, size * net.lengths
    net.mass = np.array(data.get("mass") or net.stiffness / ELASTICITY * STEEL)
    data.update(nodes=net.nodes.tolist(), unstressed_lengths=net.lengths.tolist(), mass=net.mass.tolist())
    net.give(data)
    taut("form", net.folder / "net.json", "-o", net.folder / "designed.csv")
    net.nodes = read_form(net.folder / "designed.csv", net.nodes)
    data["nodes"] = net.nodes.tolist()
    net.give(data)


def frequency(length, mass, bending, tension, fixed):
    """P. M. Morse, Vibration and Sound, 1948, section 15, to second order in 1 / xi."""
    string = np.sqrt(tension / mass) / (2 * length)
    if not fixed or bending == 0:
        return string * np.sqrt(1 + bending * (np.pi / length) ** 2 / tension)
    xi = length * np.sqrt(tension / bending)
    return string * (1 + 2 / xi + (4 + np.pi**2 / 2) / xi**2)


class Job:
    """A built net, and the files of all that is measured of it."""

    def __init__(self, net, case, seed):
        _, _, _, _, prior, noise, free_length, _, _ = case
        random = np.random.default_rng(20_000 + seed)
        unloaded = net.loads.copy()
        net.stiffness_factor, self.of_mass = 1 + random.uniform(-0.1, 0.1), 1 + 0.03 * random.normal()
        bags = np.zeros_like(net.loads)
        bags[net.free[:: len(net.free) // 5], 2] = -self.bag(net)
        net.loads = unloaded + bags * (1 + 0.02 * random.normal())
        net.data["mass"] = (self.of_mass * net.mass).tolist()
        loaded = net.build(prior, SITE, seed)[0]
        net.loads = unloaded
        self.form, self.tension, _, _ = net.build(prior, SITE, seed)
        weighed = self.of_mass / (1 + 0.005 * random.normal()) * net.mass
        for name, known in (("weighed", {}), ("of hinged", {"cable_ends": "hinged"})):
            (net.folder / f"{name}.json").write_text(json.dumps(dict(net.data, mass=weighed.tolist(), **known)))
        net.data["mass"] = net.mass.tolist()
        folder = net.folder
        seen = net.free[random.random(len(net.free)) >= 0.1]
        for file, form in (("survey.csv", self.form), ("loaded.csv", loaded)):
            write_points(folder / file, seen, (form + quantity(noise) * random.normal(size=form.shape))[seen])
        (folder / "bags.csv").write_text("".join(f"{node},0,0,{bags[node, 2]}\n" for node in np.flatnonzero(bags[:, 2])))
        taut_edges = np.flatnonzero(self.tension > 0.1 * self.tension.mean())
        self.write_forces(net, random, random.choice(taut_edges, 3 * MEASURED, replace=False), quantity(free_length))
        self.options = {
            "cells": ["--forces", folder / "cells.csv"],
            "frequencies": ["--frequencies", folder / "frequencies.csv", "--free-length-std", free_length],
            "of hinged": ["--frequencies", folder / "of_hinged.csv", "--free-length-std", free_length],
            "sags": ["--sag", folder / "sags.csv"],
            "weighed": ["--uncertain", "mass:0.5%"],
            "load": ["--epoch", f"{folder / 'loaded.csv'}::{folder / 'bags.csv'}"],
        }

    @staticmethod
    def bag(net):
        """A fifth of the mean tension, at each of about five nodes."""
        return 0.2 * net.tensions(net.nodes, net.lengths, np.ones(len(net.edges))).mean()

    def write_forces(self, net, random, edges, free_length):
        cells, vibrating, sagging = np.split(edges, 3)
        calibration = 1 + 0.01 * random.normal()
        bar = net.stiffness**2 / (ELASTICITY * 4 * np.pi)
        bending, fixed = random.uniform(0, 0.5), random.random() < 0.5
        spans = net.spans(self.form)
        lines = [f"{e},{self.tension[e] * calibration * (1 + 0.02 * random.normal())}\n" for e in cells]
        (net.folder / "cells.csv").write_text("".join(lines))
        with (net.folder / "frequencies.csv").open("w") as out, (net.folder / "of_hinged.csv").open("w") as of_hinged:
            for e in vibrating:
                length, error = spans[e] + free_length * random.normal(), 1 + 0.01 * random.normal()
                for file, are_fixed in ((out, fixed), (of_hinged, False)):
                    true = frequency(length, self.of_mass * net.mass[e], bending * bar[e], self.tension[e], are_fixed)
                    file.write(f"{e},{error * true}\n")
        with (net.folder / "sags.csv").open("w") as out:
            for e in sagging:
                start, end = self.form[net.edges[e]]
                sag = self.of_mass * net.mass[e] * GRAVITY * spans[e] ** 2 / (8 * self.tension[e])
                for part in (0.05, 0.5, 0.95):
                    place = start + part * (end - start) - [0, 0, 4 * part * (1 - part) * sag]
                    out.write(",".join(map(str, [e, *(place + SAG_POINT * random.normal(size=3)), SAG_POINT])) + "\n")


class Row:
    """One kind of evidence."""

    def __init__(self):
        self.verdicts, self.errors, self.stds = collections.Counter(), [], []
        self.means, self.tensions = Count(), Count()
        self.refused = ""

    def add(self, net, job, given, prior, noise):
        options = [word for one in given for word in job.options[one]]
        file = next((f"{known}.json" for known in ("of hinged", "weighed") if known in given), "net.json")
        found, ended = identify(net.folder, "--noise", noise, "--frame", "net", "--prior", prior, *options, net=file)
        if not found:
            self.refused = ended.stderr.strip().splitlines()[-1]
            return
        verdict = found["trust"]["verdict"]
        self.verdicts[verdict] += 1
        if verdict == "failed" or not found["mean_tension"]:
            return
        self.means.add(job.tension.mean(), found["mean_tension"])
        self.errors.append(abs(found["mean_tension"]["mean"] / job.tension.mean() - 1))
        self.stds.append(found["mean_tension"]["std"] / job.tension.mean())
        for edge in found["edges"] + found["adjustable_edges"]:
            self.tensions.add(job.tension[edge["edge"]], edge, "tension_")

    def __str__(self):
        verdicts = verdict_counts(self.verdicts)
        if not self.errors:
            return f"{verdicts or 'refused: ' + self.refused} | - | - | - | - | -"
        within = sum(error < 0.02 for error in self.errors)
        return (
            f"{verdicts} | {len(self.errors)} | {100 * np.median(self.stds):.2f} % | {100 * rms(self.errors):.2f} %, "
            f"{within} | {self.means} | {self.tensions}"
        )


def rows(case, folder):
    kind, name, size, factor, prior, noise, _, surveys, kinds = case
    net = Net(name, folder, factor)
    of_size(net, size)
    found = {evidence: Row() for evidence in EVIDENCE if evidence in kinds}
    for seed in range(surveys):
        job = Job(net, case, seed)
        for evidence, row in found.items():
            row.add(net, job, EVIDENCE[evidence], prior, noise)
    of_net = f"{kind}: `{name}`" + (f", {factor} times as stiff" if factor != 1 else "") + (f", {size} times as large" if size != 1 else "")
    for evidence, row in found.items():
        yield f"| {of_net}, {prior}, {noise} | {evidence} | {row} |"


def lines():
    yield by(__file__)
    yield from heading("net | evidence | verdicts | with tensions | std of the mean tension | its error, RMS; within 2 % | mean inside | "
                       "tensions inside")
    for case in CASES:
        with temporary_folder() as folder:
            yield from rows(case, folder)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
