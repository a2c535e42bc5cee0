# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well supports that give way are accounted for, as given and where something of them is wrong: a table of
docs/validation.md.

Every support of a net stands on a spring of its own. Besides what false_premises.py draws, all springs are off by 25 %, and
each support's place without load by 1 mm, as `taut identify` assumes by default.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/elastic_supports.py [SURVEYS] --write
"""

import false_premises
import numpy as np
from page_block import show
from simulation import Net

# net, prior, noise, surveys
CASES = [("hypar:5x5", "normal:1mm", "0.5mm", 50), ("hypar:9x9", "normal:2mm", "0.5mm", 50)]
OF_SPRINGS, OF_PLACES = 0.25, 1e-3
# A support on one frame with its neighbours passes this part of its force on to each.
OF_COUPLINGS = 0.3
# what is false: factor of all springs as given, of one of them, error of one place [m], what taut knows of them, and whether
# they are of one frame
FALSE = {
    "nothing": (1, 1, 0, "springs", False),
    "springs twice as stiff as given": (0.5, 1, 0, "springs", False),
    "springs half as stiff as given": (2, 1, 0, "springs", False),
    "one spring a fifth as stiff as given": (1, 5, 0, "springs", False),
    "one support 10 mm off": (1, 1, 10e-3, "springs", False),
    "supports taken as rigid": (1, 1, 0, "rigid", False),
    "nothing, on one frame": (1, 1, 0, "frame", True),
    "on one frame that is twice as stiff as given": (0.5, 1, 0, "frame", True),
    "on one frame, given as springs": (1, 1, 0, "springs", True),
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
            self.springs[node] = np.linalg.norm(pulls[node]) / random.uniform(0.5e-3, 2e-3, 3), pulls[node]
        self.rigid = dict(self.data)
        self.free = np.arange(len(self.nodes))

    def couplings(self):
        """Of neighbours in the list of supports."""
        supports = self.rigid["supports"]
        least = [np.minimum(self.springs[a][0], self.springs[b][0]) for a, b in zip(supports, supports[1:])]
        return [(a, b, -OF_COUPLINGS * k) for a, b, k in zip(supports, supports[1:], least)]

    def as_springs(self):
        """Of one support, under a force on it alone: by this a frame program finds it."""
        at = {node: k for k, node in enumerate(self.rigid["supports"])}
        whole = np.zeros((len(at), 3, len(at), 3))
        for node, (stiffness, _) in self.springs.items():
            whole[at[node], :, at[node], :] = np.diag(stiffness)
        for a, b, stiffness in self.couplings():
            whole[at[a], :, at[b], :] = whole[at[b], :, at[a], :] = np.diag(stiffness)
        flexibility = np.linalg.inv(whole.reshape(3 * len(at), -1))
        alone = 1 / np.diag(flexibility).reshape(-1, 3)
        forces = np.array([self.springs[node][1] for node in at])
        shifts = (flexibility @ forces.ravel()).reshape(-1, 3)
        return {node: (alone[k], shifts[k]) for node, k in at.items()}

    def on(self, change, kind, is_frame):
        """The net on springs or on a frame: change(node) gives a factor of their stiffness and a shift of their place."""
        alone = self.as_springs() if is_frame else {node: (k, pull / k) for node, (k, pull) in self.springs.items()}
        stiffness, places = [], []
        for node in self.rigid["supports"]:
            factor, shift = change(node)
            own = alone[node][0] if kind == "springs" else self.springs[node][0]
            stiffness.append((factor * own).tolist())
            moved = alone[node][1] if kind == "frame" or not is_frame else self.springs[node][1] / own
            places.append((self.nodes[node] - moved + shift).tolist())
        data = dict(self.rigid, support_stiffness=stiffness, support_place=places)
        if kind == "frame":
            data["support_couplings"] = [[a, b, np.diag(change(a)[0] * k).tolist()] for a, b, k in self.couplings()]
        return data

    def job(self, prior, noise, seed, random, factor, factor_of_one, shift_of_one, kind, is_frame):
        built = np.random.default_rng(30_000 + seed)
        true_factor = np.exp(OF_SPRINGS * built.normal())
        true_kind = "frame" if is_frame else "springs"
        self.data = self.on(lambda _: (true_factor, OF_PLACES * built.normal(size=3)), true_kind, is_frame)
        form, tension, deviations, _ = self.build(prior, false_premises.SITE, seed)
        false_premises.survey(self, form, noise, random)
        one = random.choice(self.rigid["supports"])
        up = np.array([0, 0, shift_of_one])
        given = self.on(lambda node: (factor * factor_of_one, up) if node == one else (factor, 0), kind, is_frame)
        self.give(self.rigid if kind == "rigid" else given)
        return form, tension, deviations, np.log(true_factor)


def lines():
    return false_premises.lines(__file__, CASES, FALSE, OnSprings, has_springs=True)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
