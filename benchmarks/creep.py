# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well nets whose cables creep between two surveys are identified, and where something of that is given wrong: a table of
docs/validation.md.

Besides what false_premises.py draws, each support is off by 1 mm. Lengths and tensions are those at the second survey.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/creep.py [SURVEYS] --write
"""

import false_premises
import numpy as np
from page_block import show
from simulation import Net

CASES = [("hypar:5x5", "normal:2mm", "0.5mm", 30)]
# what is false: standard deviation of the common strain, what is given of it, and that of each cable besides
FALSE = {
    "nothing": (3e-3, "creep:0.3%", 0),
    "nothing: no creep": (0, "creep:0.3%", 0),
    "creep not given": (3e-3, None, 0),
    "creep three times as given": (9e-3, "creep:0.3%", 0),
    "each cable creeps by itself as well": (3e-3, "creep:0.3%", 3e-3),
}


class Ropes(Net):
    def __init__(self, name, folder):
        super().__init__(name, folder)
        self.alter = lambda deviations, *_: deviations.__iadd__(self.crept * self.lengths)

    def job(self, prior, noise, seed, random, std, given, std_of_each):
        self.options = ["--epoch", self.folder / "later.csv"] + (["--uncertain", given] if given else [])
        common = std * random.normal()
        strain = common + std_of_each * random.normal(size=len(self.edges))
        for name, part in (("survey.csv", 0), ("later.csv", 1)):
            self.crept = part * strain
            form, tensions, deviations, _ = self.build(prior, [*false_premises.SITE, "supports:1mm"], seed)
            false_premises.survey(self, form, noise, random, name=name)
        return form, tensions, deviations - common * self.lengths


def lines():
    return false_premises.lines(__file__, CASES, FALSE, Ropes)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
