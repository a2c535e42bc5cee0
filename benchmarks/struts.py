# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well nets with struts are identified, as given and where something of the struts is wrong: a table of
docs/validation.md.

What `taut identify` assumes by default is drawn here: 5 % of all stiffnesses and 2 % of each, 1 mm of each rigid support, 0.5 mm
of turnbuckles. Nets are those of coverage.py, whose forms alone are `taut form`'s.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/struts.py --write
"""

import json
import pathlib
import tempfile

import numpy as np
from coverage import Net
from elastic_supports import SITE, Row, Totals, write_survey
from page_block import show

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


def give(net, factor, knows_struts):
    """Writes the net as taut gets it."""
    given = dict(net.data, axial_stiffness=np.where(net.is_strut, factor * net.stiffness, net.stiffness).tolist())
    if not knows_struts:
        del given["kind"]
    (net.folder / "net.json").write_text(json.dumps(given))


def rows(case, folder, totals):
    name, prior, noise, surveys = case
    net = Net(name, 1, folder)
    rigid = [k is None for k in net.data["support_stiffness"]] if "support_stiffness" in net.data else [True] * len(net.data["supports"])
    net.free = np.setdiff1d(np.arange(len(net.nodes)), np.array(net.data["supports"])[rigid])
    struts = np.intersect1d(np.flatnonzero(net.is_strut), net.interior)
    for false, (of_one, of_all, factor, knows_struts) in FALSE.items():
        row = Row()
        for seed in range(surveys):
            random = np.random.default_rng(10_000 + seed)
            one = random.choice(struts)

            def alter(deviations, nodes, _, one=one, of_one=of_one, of_all=of_all):
                deviations[struts] += of_all
                deviations[one] += of_one

            net.alter = alter
            job = net.build(prior, [*SITE, "supports:1mm"], seed)
            write_survey(net, job[0], noise, random)
            give(net, factor, knows_struts)
            row.add(net, (*job[:3], 0.0), prior, noise)
        totals.add(false, row)
        yield f"| `{name}`, {prior}, {noise}, {surveys} surveys | {false} | {str(row).rpartition(' | ')[0]} |"


def lines():
    yield "By `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/struts.py --write`:\n"
    yield "| net | what is false | verdicts | for | lengths inside | tensions inside, worst survey | mean tension inside |"
    yield "|" + "---|" * 7
    totals = Totals()
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            yield from rows(case, pathlib.Path(folder), totals)
    yield f"\nPassed, where this is false: {totals}."


if __name__ == "__main__":
    show("validation.md", "benchmarks/struts.py", lines())
