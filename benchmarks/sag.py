# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well nets of heavy cables are identified, with their sag and where something of it is wrong: a table of
docs/validation.md.

The net is `hypar:5x5` enlarged to 32 m between nodes, of cables of 10 kg/m, which hang up to 0.5 % of that below their chords. What
`taut identify` assumes by default is drawn here: 5 % of all stiffnesses and 2 % of each, 1 mm of each support, 0.5 mm of turnbuckles, 3 % of the
mass. Tensions follow from the length of the parabola, by bisection of its equation; forms alone are `taut form`'s. The instrument is
levelled, as loads need it.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/sag.py --write
"""

import csv
import json
import pathlib
import sys
import tempfile

import numpy as np
from coverage import Net, taut
from elastic_supports import SITE, Row, Totals, write_survey
from page_block import show

SURVEYS = 50
ENLARGED, MASS, STIFFNESS, TENSION, GRAVITY = 240, 10.0, 60e6, 60e3, 9.80665
# prior, noise; what is false: factor of the mass as given, whether sag is given, deviation of loose cables [m]
OF_MASS = 0.03
CASES = [("normal:5mm", "2mm"), ("normal:2mm", "0.5mm")]
FALSE = {
    "nothing": (1, True, 0),
    "mass 5 % too large": (1.05, True, 0),
    "two cables 300 mm too long, nearly slack": (1, True, 0.3),
    "sag not given": (1, False, 0),
}


class Heavy(Net):
    def __init__(self, folder):
        super().__init__("hypar:5x5", 1, folder)
        spans = self.spans(self.nodes)
        tension = (spans / self.lengths - 1) * self.stiffness
        tension *= TENSION / tension.mean()
        self.stiffness = np.full(len(self.edges), STIFFNESS)
        self.nodes *= ENLARGED
        spans = self.spans(self.nodes)
        weight = GRAVITY * MASS * spans
        self.lengths = spans / (1 + tension / STIFFNESS) * (1 + (weight / tension) ** 2 / 24)
        self.data.update(nodes=self.nodes.tolist(), axial_stiffness=self.stiffness.tolist(), unstressed_lengths=self.lengths.tolist())
        self.data.update(mass=MASS, sag_weight="mass")
        self.nodes = self.form_of(self.data)  # with the weight of the cables
        self.data["nodes"] = self.nodes.tolist()
        self.give(1, True)
        across = np.abs(self.nodes[self.edges[:, 0]] - self.nodes[self.edges[:, 1]])[:, :2]
        self.weight = GRAVITY * MASS * np.hypot(*across.T) / self.spans(self.nodes)
        self.designed_loads = np.zeros_like(self.nodes)
        for edge, length in zip(self.edges, self.lengths):
            self.designed_loads[edge, 2] -= 0.5 * GRAVITY * MASS * length
        self.designed = self.data
        # As built: the weight of the design, whatever the lengths.
        self.data = {key: value for key, value in self.data.items() if key != "mass"}

    def form_of(self, data):
        (self.folder / "design.json").write_text(json.dumps(data))
        taut("form", self.folder / "design.json", "-o", self.folder / "design.csv")
        form = self.nodes.copy()
        for row in csv.DictReader((self.folder / "design.csv").open()):
            form[int(row["id"])] = [float(row[axis]) for axis in "xyz"]
        return form

    def give(self, factor_of_mass, has_sag):
        """Writes the net as taut gets it."""
        given = dict(getattr(self, "designed", self.data), mass=factor_of_mass * MASS)
        if not has_sag:
            del given["sag_weight"]
        (self.folder / "net.json").write_text(json.dumps(given))

    def build(self, prior, uncertain, seed):
        self.of_mass = np.exp(OF_MASS * np.random.default_rng(40_000 + seed).normal())
        self.loads = self.of_mass * self.designed_loads
        self.data["sag_weight"] = (self.of_mass * self.weight).tolist()
        return super().build(prior, uncertain, seed)

    def tensions(self, form, lengths, factor):
        strain = self.spans(form) / lengths - 1
        low, high = np.full(len(lengths), 1.0), np.full(len(lengths), 1e9)
        for _ in range(200):
            middle = np.sqrt(low * high)
            longer = (self.of_mass * self.weight * lengths / middle) ** 2 / 24
            is_low = strain + longer > middle / (self.stiffness * factor)
            low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
        return middle


def rows(prior, noise, surveys, folder, totals):
    net = Heavy(folder)
    for false, (factor, has_sag, loose) in FALSE.items():
        row = Row()
        for seed in range(surveys):
            random = np.random.default_rng(10_000 + seed)
            two = random.choice(net.interior, 2, replace=False)

            def alter(deviations, nodes, _, two=two, loose=loose):
                deviations[two] += loose

            net.alter = alter
            job = net.build(prior, [*SITE, "supports:1mm"], seed)
            write_survey(net, job[0], noise, random, is_levelled=True)
            net.give(factor, has_sag)
            row.add(net, (*job[:3], 0.0), prior, noise)
        totals.add(false, row)
        yield f"| {prior}, {noise}, {surveys} surveys | {false} | {str(row).rpartition(' | ')[0]} |"


def lines(surveys=SURVEYS):
    yield "By `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/sag.py --write`:\n"
    yield "| prior, noise | what is false | verdicts | for | lengths inside | tensions inside, worst survey | mean tension inside |"
    yield "|" + "---|" * 7
    totals = Totals()
    for prior, noise in CASES:
        with tempfile.TemporaryDirectory() as folder:
            yield from rows(prior, noise, surveys, pathlib.Path(folder), totals)
    yield f"\nPassed, where this is false: {totals}."


if __name__ == "__main__":
    if sys.argv[1:] and sys.argv[1].isdigit():  # a few surveys, for a look
        print(*lines(int(sys.argv[1])), sep="\n")
    else:
        show("validation.md", "benchmarks/sag.py", lines())
