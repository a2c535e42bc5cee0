# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well nets of heavy cables are identified, with their sag and where something of it is wrong: a table of
docs/validation.md.

The net is `hypar:5x5` enlarged to 32 m between nodes, of cables of 10 kg/m, which hang up to 0.5 % of that below their chords. Besides what
false_premises.py draws, each support is off by 1 mm, and the mass by 3 %. Tensions follow from the length of the parabola, by
bisection of its equation. The instrument is levelled, as loads need it.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/sag.py [SURVEYS] --write
"""

import json

import false_premises
import numpy as np
from page_block import show
from simulation import Net, read_form, taut

ENLARGED, MASS, STIFFNESS, TENSION, GRAVITY = 240, 10.0, 60e6, 60e3, 9.80665
OF_MASS = 0.03
# no title, prior, noise, surveys
CASES = [("", "normal:5mm", "2mm", 50), ("", "normal:2mm", "0.5mm", 50)]
# what is false: factor of the mass as given, whether sag is given, deviation of loose cables [m]
FALSE = {
    "nothing": (1, True, 0),
    "mass 5 % too large": (1.05, True, 0),
    "two cables 300 mm too long, nearly slack": (1, True, 0.3),
    "sag not given": (1, False, 0),
}


class Heavy(Net):
    def __init__(self, _, folder):
        super().__init__("hypar:5x5", folder)
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
        (folder / "design.json").write_text(json.dumps(self.data))
        taut("form", folder / "design.json", "-o", folder / "design.csv")
        self.nodes = read_form(folder / "design.csv", self.nodes)  # with the weight of the cables
        self.data["nodes"] = self.nodes.tolist()
        across = np.abs(self.nodes[self.edges[:, 0]] - self.nodes[self.edges[:, 1]])[:, :2]
        self.weight = GRAVITY * MASS * np.hypot(*across.T) / self.spans(self.nodes)
        self.designed_loads = np.zeros_like(self.nodes)
        for edge, length in zip(self.edges, self.lengths):
            self.designed_loads[edge, 2] -= 0.5 * GRAVITY * MASS * length
        self.designed = self.data
        # As built: the weight of the design, whatever the lengths.
        self.data = {key: value for key, value in self.data.items() if key != "mass"}

    def job(self, prior, noise, seed, random, factor, has_sag, loose):
        two = random.choice(self.interior, 2, replace=False)

        def alter(deviations, *_):
            deviations[two] += loose

        self.alter = alter
        self.of_mass = np.exp(OF_MASS * np.random.default_rng(40_000 + seed).normal())
        self.loads = self.of_mass * self.designed_loads
        self.data["sag_weight"] = (self.of_mass * self.weight).tolist()
        job = self.build(prior, [*false_premises.SITE, "supports:1mm"], seed)
        false_premises.survey(self, job[0], noise, random, is_levelled=True)
        given = dict(self.designed, mass=factor * MASS)
        if not has_sag:
            del given["sag_weight"]
        self.give(given)
        return job[:3]

    def tensions(self, form, lengths, factor):
        strain = self.spans(form) / lengths - 1
        low, high = np.full(len(lengths), 1.0), np.full(len(lengths), 1e9)
        for _ in range(200):
            middle = np.sqrt(low * high)
            longer = (self.of_mass * self.weight * lengths / middle) ** 2 / 24
            is_low = strain + longer > middle / (self.stiffness * factor)
            low, high = np.where(is_low, middle, low), np.where(is_low, high, middle)
        return middle


def lines():
    return false_premises.lines(__file__, CASES, FALSE, Heavy)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
