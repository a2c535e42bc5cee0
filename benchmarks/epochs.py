# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What a second survey adds after turning, and what taut reports where the turns are not as given: tables of
docs/diagnostics.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/epochs.py --write
"""

import csv
import json
from collections import Counter

import numpy as np
from page_block import by, count_given, heading, show
from simulation import Net, drawn, holds, identify, percent, quantity, read_form, taut, temporary_folder, write_points, write_survey

JOBS = 10
LAW = "uniform:5mm"
SETTINGS = [("hilo-quarter", "0.5mm", "10%"), ("hilo-quarter", "2mm", "30%"), ("hypar:9x9", "0.5mm", "10%")]


class Job:
    """A net as built: surveyed, turned by a plan, surveyed again. Files of the folder."""

    def __init__(self, net, noise, hidden, folder, seed):
        self.net, self.noise, self.hidden, self.folder = net, noise, hidden, folder
        self.options, self.moved, self.is_copied = [], {}, False
        self.random = np.random.default_rng(seed)
        self.deviations = np.zeros(len(net.edges))
        self.deviations[net.interior] = drawn(LAW, len(net.interior), self.random)
        self.survey("first.csv", {})
        self.identify("first.csv", "--draws", "40")
        taut("plan", folder / "net.json", folder / "result.json", "-o", folder / "plan.json", "--csv",
             folder / "turns.csv", "--tension", "1.5kN..10kN" if net.data["name"] == "hilo-quarter" else "0.1kN..")
        self.given = {}
        if (folder / "turns.csv").exists():
            ids = net.data.get("edge_ids") or [str(e) for e in range(len(net.edges))]
            lines = (folder / "turns.csv").read_text().splitlines()
            for row in csv.DictReader(line for line in lines if not line.startswith("#")):
                edge = ids.index(row["edge"])
                self.given[edge] = self.given.get(edge, 0.0) + 1e-3 * float(row["stroke_mm"])

    def survey(self, name, turned, slipped=None, noise=None):
        data = dict(self.net.data)
        lengths = self.net.lengths + self.deviations
        for edge, stroke in {**turned, **(slipped or {})}.items():
            lengths[edge] += stroke
        data["unstressed_lengths"] = lengths.tolist()
        data["nodes"] = [[x, y, z + self.moved.get(n, 0.0)] for n, (x, y, z) in enumerate(data["nodes"])]
        (self.folder / "built.json").write_text(json.dumps(data))
        taut("form", self.folder / "built.json", "-o", self.folder / "built.csv", "--quiet")
        form, std = read_form(self.folder / "built.csv", np.zeros_like(self.net.nodes)), quantity(noise or self.noise)
        write_survey(self.folder / name, self.net.free, lambda node: form[node] + std * self.random.normal(size=3), self.random,
                     quantity(self.hidden))

    def give(self, turned):
        """Writes what is given of the turns."""
        with (self.folder / "turned.csv").open("w") as out:
            out.write("edge,stroke\n")
            for edge, stroke in turned.items():
                out.write(f"{edge},{stroke!r}\n")

    def identify(self, survey, *options):
        """Length deviations, whether their intervals hold the truth, and the result."""
        data, ended = identify(self.folder, "--noise", self.noise, "--frame", "net", "--uncertain", "none", *self.options, *options,
                               survey=survey)
        if not data:
            return None, None, {"trust": {"verdict": "refused", "reasons": [ended.stderr.strip()]}}
        found = np.array([e["length_deviation"] for e in data["edges"]])
        truth = self.deviations[[e["edge"] for e in data["edges"]]]
        return found - truth, np.mean([holds(e, t) for e, t in zip(data["edges"], truth)]), data

    def again(self, survey="second.csv", turned="turned.csv"):
        epoch = str(self.folder / survey) + (f":{self.folder / turned}" if turned else "")
        return self.identify("first.csv", "--draws", "0", "--epoch", epoch)


def average_of_files(job):
    """One survey of the mean places of two."""
    places = {}
    for name in ("first.csv", "same.csv"):
        for row in csv.reader((job.folder / name).open()):
            places.setdefault(row[0], []).append(np.array(row[1:], float))
    noise = quantity(job.noise)
    with (job.folder / "mean.csv").open("w") as out:
        out.write("id,x,y,z,sx,sy,sz\n")
        for node, seen in places.items():
            std = noise / np.sqrt(len(seen))
            out.write(",".join([node, *map(repr, map(float, np.mean(seen, axis=0))), *[repr(std)] * 3]) + "\n")


def gains(net, noise, hidden, folder, jobs):
    errors, inside = {}, {}
    for seed in range(jobs):
        job = Job(net, noise, hidden, folder, seed)
        job.survey("second.csv", job.given)
        job.survey("same.csv", {})
        job.give(job.given)
        average_of_files(job)
        one = job.identify("first.csv", "--draws", "0")
        other = job.identify("same.csv", "--draws", "0")
        ways = {
            "one": one[:2],
            "mean of two results": ((one[0] + other[0]) / 2, np.nan),
            "mean of two surveys": job.identify("mean.csv", "--draws", "0")[:2],
            "both surveys of one state": job.again("same.csv", None)[:2],
            "both, turned in between": job.again()[:2],
        }
        for way, (error, share) in ways.items():
            errors.setdefault(way, []).append(np.mean(np.square(error)))
            inside.setdefault(way, []).append(share)
    root = {way: 1e3 * np.sqrt(np.mean(values)) for way, values in errors.items()}
    cells = [f"{root[way]:.3f}" + ("" if np.isnan(inside[way][0]) else f" ({100 * np.mean(inside[way]):.1f})") for way in root]
    return f"| {net.data['name']}, {noise}, {hidden} hidden | " + " | ".join(cells) + " |"


def turned_the_wrong_way(job):
    edge = max(job.given, key=lambda e: abs(job.given[e]))
    return {**job.given, edge: -job.given[edge]}, {}, {edge}


def forgotten(job):
    edge = sorted(job.given, key=lambda e: -abs(job.given[e]))[3]
    return {**job.given, edge: 0.0}, {}, {edge}


def three_off(job):
    edges = sorted(job.given)[5::20][:3]
    return {e: s + (4e-3 if e in edges else 0.0) for e, s in job.given.items()}, {}, set(edges)


def slipped(job):
    edge = int(job.net.interior[len(job.net.interior) // 3])
    return job.given, {edge: 5e-3}, {edge}


def two_slipped(job):
    edges = [int(job.net.interior[len(job.net.interior) * k // 7]) for k in (2, 5)]
    return job.given, {edge: -5e-3 for edge in edges}, set(edges)


def wrong_pitch(job):
    return {e: 1.2 * s for e, s in job.given.items()}, {}, set()


def wrong_signs(job):
    return {e: -s for e, s in job.given.items()}, {}, set()


def none_turned(_):
    return {}, {}, set()


def actuator_not_given(job):
    return {e: s + 0.7e-3 * job.random.normal() for e, s in job.given.items()}, {}, set()


def off_from_the_start(job):
    start = {job.net.data["adjustable"][11]: 6e-3}
    job.survey("first.csv", start)
    return {e: job.given.get(e, 0.0) + start.get(e, 0.0) for e in {**job.given, **start}}, {}, set(start)


def support_moved(job):
    node = job.net.data["supports"][7]
    job.moved = {node: 8e-3}
    at_it = {e for e, ends in enumerate(job.net.edges) if node in ends}
    return job.given, {}, at_it


def supports_off(job):
    job.moved = {node: 1e-3 * job.random.normal() for node in job.net.data["supports"]}
    job.survey("first.csv", {})
    return job.given, {}, set()


def supports_off_assumed(job):
    job.options = ["--uncertain", "supports:1mm"]
    return supports_off(job)


def narrow_prior(job):
    job.options = ["--prior", "uniform:2mm"]
    return job.given, {}, set()


def one_survey_twice(job):
    job.is_copied = True
    job.given = {}
    return {}, {}, set()


FALSE = [
    ("nothing", lambda job: (job.given, {}, set())),
    ("one turned the wrong way", turned_the_wrong_way),
    ("one not turned", forgotten),
    ("three turned 4 mm too far", three_off),
    ("a cable slipped by 5 mm", slipped),
    ("two cables 5 mm shorter than before", two_slipped),
    ("a turnbuckle 6 mm off from the start", off_from_the_start),
    ("a support 8 mm higher than before", support_moved),
    ("each support 1 mm higher or lower", supports_off),
    ("the same, supports assumed uncertain by 1 mm", supports_off_assumed),
    ("all turned 20 % too far", wrong_pitch),
    ("all turned the wrong way", wrong_signs),
    ("none turned", none_turned),
    ("0.7 mm of play, not given", actuator_not_given),
    ("prior given as uniform:2mm", narrow_prior),
    ("one survey given twice, rounded to 0.1 mm", one_survey_twice),
]


def false_premise(name, alter, net, folder, jobs):
    said, inside, named, expected, false_alarms, silent = Counter(), [], 0, 0, 0, 0
    for seed in range(jobs):
        job = Job(net, "0.5mm", "10%", folder, 100 + seed)
        done, slip, suspects = alter(job)
        if job.is_copied:
            rows = [row.split(",") for row in (folder / "first.csv").read_text().split()]
            write_points(folder / "second.csv", [row[0] for row in rows], [[f"{float(x):.4f}" for x in row[1:]] for row in rows])
        else:
            job.survey("second.csv", done, slip)
        job.give(job.given)
        # What the last survey saw.
        for edge, change in slip.items():
            job.deviations[edge] += change
        _, share, result = job.again(turned="turned.csv" if job.given else None)
        said[result["trust"]["verdict"]] += 1
        if share is None:
            continue
        inside.append(share)
        silent += result["trust"]["verdict"] == "passed" and share < 0.85
        accused = {c["edge"] for epoch in result["epochs"] for c in epoch["changes"]}
        accused |= {b["edge"] for epoch in result["epochs"] for b in epoch["boundary"] if "edge" in b}
        named += len(accused & suspects)
        expected += len(suspects)
        false_alarms += len(accused - suspects) if suspects or name == "nothing" else 0
        false_alarms += sum(len(epoch["outliers"]) for epoch in result["epochs"])
    verdicts = ", ".join(f"{verdict} {count}" for verdict, count in said.most_common())
    return f"| {name} | {percent(inside)} | {f'{named} of {expected}' if expected else '-'} | {false_alarms} | {verdicts} | {silent} |"


def lines():
    jobs = count_given(JOBS)
    yield by(__file__, f", {jobs} jobs a row")
    yield from heading("net, noise | one survey | mean of two results | mean of two surveys | both surveys of one state | "
                       "both, turned in between")
    for name, noise, hidden in SETTINGS:
        with temporary_folder() as folder:
            yield gains(Net(name, folder), noise, hidden, folder, jobs)
    yield ""
    yield from heading("what is wrong | lengths inside 95 % [%] | suspects right | false alarms | verdict | passed below 85 %")
    for name, alter in FALSE:
        with temporary_folder() as folder:
            yield false_premise(name, alter, Net("hilo-quarter", folder), folder, jobs)


if __name__ == "__main__":
    show("diagnostics.md", __file__, lines())
