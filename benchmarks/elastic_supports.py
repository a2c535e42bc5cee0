# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well supports that give way are accounted for, as given and where something of them is wrong: a table of
docs/validation.md.

Every support of a net stands on a spring of its own. Besides what false_premises.py draws, all springs are off by 10 %, and
each support's place without load by 1 mm, as `taut identify` assumes by default.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/elastic_supports.py [SURVEYS] --write
"""

import false_premises
import numpy as np
from page_block import show
from simulation import Net

# net, prior, noise, surveys
CASES = [("hypar:5x5", "normal:1mm", "0.5mm", 50), ("hypar:9x9", "normal:2mm", "0.5mm", 50)]
OF_SPRINGS, OF_PLACES = 0.1, 1e-3
# what is false: factor of all springs as given, of one of them, error of one place [m], whether taut knows of springs
FALSE = {
    "nothing": (1, 1, 0, True),
    "springs twice as stiff as given": (0.5, 1, 0, True),
    "springs half as stiff as given": (2, 1, 0, True),
    "one spring a fifth as stiff as given": (1, 5, 0, True),
    "one support 10 mm off": (1, 1, 10e-3, True),
    "supports taken as rigid": (1, 1, 0, False),
}


class OnSprings(Net):
    """Each support moves by 0.5 to 2 mm under the design's forces, which balance the springs at the nodes."""

    def __init__(self, name, folder):
        super().__init__(name, folder)
        pulls = np.zeros_like(self.nodes)
        along = self.nodes[self.edges[:, 1]] - self.nodes[self.edges[:, 0]]
        tension = self.tensions(self.nodes, self.lengths, np.ones(len(self.edges)))
        force = along * (tension / np.linalg.norm(along, axis=1))[:, None]
        np.add.at(pulls, self.edges[:, 0], force)
        np.add.at(pulls, self.edges[:, 1], -force)
        random = np.random.default_rng(1)
        self.springs = {}
        for node in self.data["supports"]:
            stiffness = np.linalg.norm(pulls[node]) / random.uniform(0.5e-3, 2e-3, 3)
            self.springs[node] = stiffness, self.nodes[node] - pulls[node] / stiffness
        self.rigid = dict(self.data)
        self.free = np.arange(len(self.nodes))

    def on(self, change):
        """The net on springs: change(node) gives a factor of their stiffness and a shift of their place."""
        changed = {node: (factor * k, place + shift) for node, (k, place) in self.springs.items() for factor, shift in [change(node)]}
        stiffness, places = zip(*(changed[node] for node in self.rigid["supports"]))
        return dict(self.rigid, support_stiffness=np.array(stiffness).tolist(), support_place=np.array(places).tolist())

    def job(self, prior, noise, seed, random, factor, factor_of_one, shift_of_one, is_elastic):
        built = np.random.default_rng(30_000 + seed)
        true_factor = np.exp(OF_SPRINGS * built.normal())
        self.data = self.on(lambda _: (true_factor, OF_PLACES * built.normal(size=3)))
        form, tension, deviations, _ = self.build(prior, false_premises.SITE, seed)
        false_premises.survey(self, form, noise, random)
        one = random.choice(self.rigid["supports"])
        up = np.array([0, 0, shift_of_one])
        given = self.on(lambda node: (factor * factor_of_one, up) if node == one else (factor, 0))
        self.give(given if is_elastic else self.rigid)
        return form, tension, deviations, np.log(true_factor)


def lines():
    return false_premises.lines(__file__, CASES, FALSE, OnSprings, has_springs=True)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
