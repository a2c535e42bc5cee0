# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Studies of a net of which one thing is given wrong: tables of docs/validation.md.

What `taut identify` assumes by default is drawn: 5 % of all stiffnesses and 2 % of each, 0.5 mm of turnbuckles, and
what the net of a study adds.
"""

import collections

import numpy as np
from page_block import by, count_given, heading
from simulation import Count, identify, quantity, temporary_folder, verdict_counts, write_points

SITE = ["stiffness:5%", "stiffness-each:2%", "adjustable:0.5mm"]


class Row:
    def __init__(self):
        self.verdicts, self.reasons = collections.Counter(), collections.Counter()
        self.lengths, self.tensions, self.means, self.springs = (Count() for _ in range(4))
        self.worst = 100.0

    def add(self, net, job, prior, noise):
        found, ended = identify(net.folder, "--noise", noise, "--prior", prior, *net.options)
        if not found:
            if ended.returncode != 1:
                raise SystemExit(ended.stderr)
            self.verdicts["refused"] += 1
            return
        verdict = found["trust"]["verdict"]
        self.verdicts[verdict] += 1
        if verdict != "passed":
            self.reasons[found["findings"][0]["kind"].replace("_", " ")] += 1
        if verdict == "failed" or not found["mean_tension"]:
            return
        _, tension, deviations, *factor = job
        own = Count()
        for edge in found["edges"]:
            self.lengths.add(deviations[edge["edge"]], edge)
        for edge in found["edges"] + found["adjustable_edges"]:
            for count in (own, self.tensions):
                count.add(tension[edge["edge"]], edge, "tension_")
        self.worst = min(self.worst, 100 * own.inside / own.all)
        self.means.add(tension[~net.is_strut].mean(), found["mean_tension"])
        for one in found["uncertain"]:
            if factor and one["name"] == "support-stiffness":
                self.springs.add_estimate(*factor, one["mean"], one["std"])

    def cells(self):
        reasons = ", ".join(f"{kind} ({count})" for kind, count in self.reasons.most_common(2)) or "-"
        worst = f"{self.worst:.0f}" if self.tensions.all else "-"
        return [verdict_counts(self.verdicts), reasons, self.lengths, f"{self.tensions}, {worst}", self.means, self.springs]


def in_a_frame(form, random, is_levelled):
    """The form in a coordinate system of the survey that is off by 5 mm and 2 mrad about each axis, or about z alone."""
    turn = np.zeros((3, 3))
    turn[[2, 0, 1], [1, 2, 0]] = 2e-3 * random.normal(size=3)
    if is_levelled:
        turn[[2, 0], [1, 2]] = 0
    half = 0.5 * (turn - turn.T)
    rotation = np.linalg.solve(np.eye(3) - half, np.eye(3) + half)  # A. Cayley's: of the same angles, and rigid
    middle = form.mean(axis=0)
    return middle + (form - middle) @ rotation.T + 5e-3 * random.normal(size=3)


def survey(net, form, noise, random, is_levelled=False, name="survey.csv"):
    """Nine of ten free nodes, in a coordinate system of their own, with noise."""
    seen = net.free[random.random(len(net.free)) >= 0.1]
    places = in_a_frame(form, random, is_levelled) + quantity(noise) * random.normal(size=form.shape)
    write_points(net.folder / name, seen, places[seen])


def lines(script, cases, premises, make, has_springs=False):
    """The block of a study.

    cases: title, prior, noise, surveys
    make: make(title, folder) is a net with net.job(prior, noise, seed, random, *premise), which writes what taut gets and
        returns the true form, tensions and length deviations, with springs also the logarithm of their factor
    """
    count = 6 if has_springs else 5
    titles = ["net", "what is false", "verdicts", "for", "lengths inside", "tensions inside, worst survey", "mean tension inside",
              "stiffness of supports inside"]
    yield by(script)
    yield from heading(" | ".join(titles[: count + 2] if cases[0][0] else ["prior, noise", *titles[1 : count + 2]]))
    passed, tried = collections.Counter(), collections.Counter()
    for title, prior, noise, surveys in cases:
        surveys = count_given(surveys)
        with temporary_folder() as folder:
            net = make(title, folder)
            for false, premise in premises.items():
                row = Row()
                for seed in range(surveys):
                    job = net.job(prior, noise, seed, np.random.default_rng(10_000 + seed), *premise)
                    row.add(net, job, prior, noise)
                passed[false] += row.verdicts["passed"]
                tried[false] += row.verdicts.total()
                of_net = f"`{title}`, " if title else ""
                yield f"| {of_net}{prior}, {noise}, {surveys} surveys | {false} | {' | '.join(map(str, row.cells()[:count]))} |"
    totals = "; ".join(f"{false}: {passed[false]} of {tried[false]}" for false in tried)
    yield f"\nPassed, where this is false: {totals}."
