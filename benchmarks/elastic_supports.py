# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how well supports that give way are accounted for, as given and where something of them is wrong: a table of
docs/validation.md.

Every support of a net stands on a spring of its own. What `taut identify` assumes by default is drawn here: 5 % of all
stiffnesses and 2 % of each, 10 % of all springs, 1 mm of each support's place without load, 0.5 mm of turnbuckles. Nets are
those of coverage.py, whose forms alone are `taut form`'s.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/elastic_supports.py --write
"""

import collections
import json
import pathlib
import tempfile

import numpy as np
from coverage import Count, Net, quantity, taut
from page_block import show

# net, prior, noise, surveys
CASES = [("hypar:5x5", "normal:1mm", "0.5mm", 50), ("hypar:9x9", "normal:2mm", "0.5mm", 50)]
SITE = ["stiffness:5%", "stiffness-each:2%", "adjustable:0.5mm"]
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
        super().__init__(name, 1, folder)
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

    def give(self, factor, factor_of_one, shift_of_one, is_elastic, one):
        """Writes the net as taut gets it."""
        given = dict(self.rigid)
        if is_elastic:
            stiffness = {node: factor * k * (factor_of_one if node == one else 1) for node, (k, _) in self.springs.items()}
            places = {node: place + (shift_of_one if node == one else 0) * np.array([0, 0, 1]) for node, (_, place) in self.springs.items()}
            given["support_stiffness"] = [stiffness[node].tolist() for node in given["supports"]]
            given["support_place"] = [places[node].tolist() for node in given["supports"]]
        (self.folder / "net.json").write_text(json.dumps(given))

    def built(self, prior, seed):
        random = np.random.default_rng(30_000 + seed)
        factor = np.exp(OF_SPRINGS * random.normal())
        self.data = dict(self.rigid)
        self.data["support_stiffness"] = [(factor * self.springs[node][0]).tolist() for node in self.data["supports"]]
        self.data["support_place"] = [(self.springs[node][1] + OF_PLACES * random.normal(size=3)).tolist() for node in self.data["supports"]]
        form, tension, deviations, _ = self.build(prior, SITE, seed)
        return form, tension, deviations, np.log(factor)


class Row:
    def __init__(self):
        self.verdicts, self.reasons = collections.Counter(), collections.Counter()
        self.lengths, self.tensions, self.means, self.springs = (Count() for _ in range(4))
        self.worst = 100.0

    def add(self, net, job, prior, noise):
        result = net.folder / "result.json"
        command = ["identify", net.folder / "net.json", net.folder / "survey.csv", "--noise", noise]
        done = taut(*command, "--prior", prior, "--quiet", "-o", result)
        if not result.exists():
            if done.returncode != 1:
                raise SystemExit(done.stderr)
            self.verdicts["refused"] += 1
            return
        found = json.loads(result.read_text())
        result.unlink()
        verdict = found["trust"]["verdict"]
        self.verdicts[verdict] += 1
        if verdict != "passed":
            self.reasons[found["findings"][0]["kind"].replace("_", " ")] += 1
        if verdict == "failed" or not found["mean_tension"]:
            return
        _, tension, deviations, factor = job
        own = Count()
        for edge in found["edges"]:
            self.lengths.add(deviations[edge["edge"]], edge)
        for edge in found["edges"] + found["adjustable_edges"]:
            for count in (own, self.tensions):
                count.add(tension[edge["edge"]], edge, "tension_")
        self.worst = min(self.worst, 100 * own.inside / own.all)
        self.means.add(tension[~net.is_strut].mean(), found["mean_tension"])
        for one in found["uncertain"]:
            if one["name"] == "support-stiffness":
                half = 1.96 * one["std"]
                self.springs.add(factor, {"lower": one["mean"] - half, "upper": one["mean"] + half})

    def __str__(self):
        verdicts = ", ".join(f"{self.verdicts[word]} {word}" for word in ("passed", "doubtful", "failed", "refused") if self.verdicts[word])
        reasons = ", ".join(f"{kind} ({count})" for kind, count in self.reasons.most_common(2)) or "-"
        worst = f"{self.worst:.0f}" if self.tensions.all else "-"
        return f"{verdicts} | {reasons} | {self.lengths} | {self.tensions}, {worst} | {self.means} | {self.springs}"


def in_a_frame(form, random, is_levelled=False):
    """The form in a coordinate system of the survey that is off by 5 mm and 2 mrad about each axis, or about z alone."""
    turn = np.zeros((3, 3))
    turn[[2, 0, 1], [1, 2, 0]] = 2e-3 * random.normal(size=3)
    if is_levelled:
        turn[[2, 0], [1, 2]] = 0
    half = 0.5 * (turn - turn.T)
    rotation = np.linalg.solve(np.eye(3) - half, np.eye(3) + half)  # A. Cayley's: of the same angles, and rigid
    middle = form.mean(axis=0)
    return middle + (form - middle) @ rotation.T + 5e-3 * random.normal(size=3)


def write_survey(net, form, noise, random, is_levelled=False):
    """Nine of ten free nodes, in a coordinate system of their own, with noise."""
    seen = net.free[random.random(len(net.free)) >= 0.1]
    places = in_a_frame(form, random, is_levelled) + quantity(noise) * random.normal(size=form.shape)
    lines = [f"{node}," + ",".join(map(repr, map(float, places[node]))) + "\n" for node in seen]
    (net.folder / "survey.csv").write_text("".join(lines))


def rows(case, folder, totals):
    name, prior, noise, surveys = case
    net = OnSprings(name, folder)
    found = {false: Row() for false in FALSE}
    for seed in range(surveys):
        job = net.built(prior, seed)
        random = np.random.default_rng(10_000 + seed)
        write_survey(net, job[0], noise, random)
        one = random.choice(net.rigid["supports"])
        for false, row in found.items():
            net.give(*FALSE[false], one)
            row.add(net, job, prior, noise)
    for false, row in found.items():
        totals.add(false, row)
        yield f"| `{name}`, {prior}, {noise}, {surveys} surveys | {false} | {row} |"


class Totals:
    """Over all nets: how many passed of each false premise."""

    def __init__(self):
        self.passed, self.all = collections.Counter(), collections.Counter()

    def add(self, false, row):
        self.passed[false] += row.verdicts["passed"]
        self.all[false] += row.verdicts.total()

    def __str__(self):
        return "; ".join(f"{false}: {self.passed[false]} of {self.all[false]}" for false in self.all)


def lines():
    yield "By `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/elastic_supports.py --write`:\n"
    yield "| net | what is false | verdicts | for | lengths inside | tensions inside, worst survey | mean tension inside | stiffness of supports inside |"
    yield "|" + "---|" * 8
    totals = Totals()
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            yield from rows(case, pathlib.Path(folder), totals)
    yield f"\nPassed, where this is false: {totals}."


if __name__ == "__main__":
    show("validation.md", "benchmarks/elastic_supports.py", lines())
