# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well nets with struts are identified, as given and where something of the struts is wrong: a table of
docs/validation.md. Besides what false_premises.py draws, each rigid support is off by 1 mm.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/struts.py [SURVEYS] --write
"""

import false_premises
import numpy as np
from page_block import show
from simulation import Net

# net, prior, noise, surveys
CASES = [
    ("cable-dome", "normal:1mm", "0.5mm", 50),
    ("spoke-wheel", "normal:1mm", "0.5mm", 50),
    ("tensegrity-simplex", "normal:0.5mm", "0.3mm", 50),
]
# what is false: error of one strut, of all [m], factor of their stiffness as given, whether taut knows of struts
FALSE = {
    "nothing": (0, 0, 1, True),
    "one strut 10 mm too long": (10e-3, 0, 1, True),
    "all struts 2 mm too short": (0, -2e-3, 1, True),
    "struts a fifth stiffer than given": (0, 0, 1 / 1.2, True),
    "struts given as cables": (0, 0, 1, False),
}


class WithStruts(Net):
    def __init__(self, name, folder):
        super().__init__(name, folder)
        supports = np.array(self.data["supports"])
        rigid = [k is None for k in self.data.get("support_stiffness", [None] * len(supports))]
        self.free = np.setdiff1d(np.arange(len(self.nodes)), supports[rigid])
        self.struts = np.intersect1d(np.flatnonzero(self.is_strut), self.interior)

    def job(self, prior, noise, seed, random, of_one, of_all, factor, knows_struts):
        one = random.choice(self.struts)

        def alter(deviations, *_):
            deviations[self.struts] += of_all
            deviations[one] += of_one

        self.alter = alter
        job = self.build(prior, [*false_premises.SITE, "supports:1mm"], seed)
        false_premises.survey(self, job[0], noise, random)
        given = dict(self.data, axial_stiffness=np.where(self.is_strut, factor * self.stiffness, self.stiffness).tolist())
        if not knows_struts:
            del given["kind"]
        self.give(given)
        return job[:3]


def lines():
    return false_premises.lines(__file__, CASES, FALSE, WithStruts)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
