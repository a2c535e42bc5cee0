# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well a net with a cable that slides is identified, and where something of that is given wrong: a table of
docs/validation.md.

The net is `sliding-ridge`. Besides what false_premises.py draws, each support is off by 1 mm. A length between nodes is compared with
that after sliding.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/sliding.py [SURVEYS] --write
"""

import json

import false_premises
import numpy as np
from page_block import show
from simulation import Net, taut

# no title, prior, noise, surveys
CASES = [("", "normal:5mm", "2mm", 50), ("", "normal:2mm", "0.5mm", 50)]
# what is false: friction as given and as it is, and how many of its nodes slide as given and as they are
FALSE = {
    "nothing": (0.1, 0.1, 7, 7),
    "friction not given, 0.1": (None, 0.1, 7, 7),
    "friction not given, none": (None, 0.0, 7, 7),
    "friction of 0.1 given as 0": (0.0, 0.1, 7, 7),
    "friction of 0.3 given as 0.1": (0.1, 0.3, 7, 7),
    "held by a clamp where it is given to slide": (0.1, 0.1, 7, 6),
    "slides through a node where a clamp is given": (0.1, 0.1, 6, 7),
    "slides, and is given as clamped at all nodes": (0.1, 0.1, 0, 7),
}


class Ridge(Net):
    def __init__(self, _, folder):
        super().__init__("sliding-ridge", folder)
        (self.run,) = self.data["runs"]

    def sliding(self, friction, nodes):
        run = dict(self.run, slides_at=nodes)
        del run["friction"]
        return [run if friction is None else dict(run, friction=friction)]

    def job(self, prior, noise, seed, random, given, true, slides, really):
        nodes = random.permutation(self.run["slides_at"]).tolist()
        self.data["runs"] = self.sliding(true, nodes[:really])
        form, tensions, _, _ = self.build(prior, [*false_premises.SITE, "supports:1mm"], seed)
        false_premises.survey(self, form, noise, random)
        self.give(dict(self.data, runs=self.sliding(given, nodes[:slides])))
        return form, tensions, self.slid - self.lengths

    def tensions(self, form, lengths, factor):
        taut("export", self.folder / "built.json", "--to", "net", "-o", self.folder / "slid.json")
        self.slid = np.array(json.loads((self.folder / "slid.json").read_text())["unstressed_lengths"])
        return super().tensions(form, self.slid, factor)


def lines():
    return false_premises.lines(__file__, CASES, FALSE, Ridge)


if __name__ == "__main__":
    show("validation.md", __file__, lines())
