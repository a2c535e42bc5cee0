# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What taut reports where an assumption is not true: a table of docs/diagnostics.md.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/diagnostics.py --write [SURVEYS [CASE]]
"""

import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from page_block import DOCS, by, heading, show
from simulation import Net, either_of, holds, identify, percent, quantity, rms, temporary_folder, write_survey

SURVEYS = 50
NET = "hilo-quarter"
NOISE = "0.5mm"


class Case:
    """One false assumption. All that is not named is true.

    uncertain: as --uncertain, by which the net is built otherwise, and which taut is not given.
    """

    def __init__(self, name, truth="uniform:5mm", given=None, alter=None, survey=None, noise=NOISE, given_noise=None,
                 frame="net", suspects=0, options=(), net=NET, heavy=False, uncertain=(), cells=0, cells_off=0.0,
                 by_axis=(1, 1, 1), hangs=0.0):
        self.by_axis, self.hangs = by_axis, hangs  # factors of the noise; load at each free node, as given [N]
        # Load cells: forces measured to 2 %, and off by a part, the same or each by its own.
        self.cells, self.cells_off = cells, np.broadcast_to(cells_off, cells)
        self.uncertain = list(uncertain)
        self.name, self.truth, self.given, self.alter, self.survey = name, truth, given, alter, survey
        self.noise, self.given_noise, self.frame = noise, given_noise or noise, frame
        self.suspects, self.options, self.net, self.heavy = suspects, list(options), net, heavy

    def error(self, random):
        """Of one surveyed place; heavy: Student's t with three degrees of freedom, of the same variance."""
        normal = random.standard_t(3, 3) / np.sqrt(3) if self.heavy else random.normal(size=3)
        return quantity(self.noise) * np.array(self.by_axis) * normal


def off(kind, count, by):
    """So many edges of a kind, "interior" or "adjustable", longer than given; None: all."""

    def alter(net, deviations, nodes, random):
        of_kind = getattr(net, kind)
        edges = random.choice(of_kind, count or len(of_kind), replace=False)
        deviations[edges] = by
        return {("edge", edge) for edge in edges.tolist()}

    return alter


def warmer(by):
    """All cables are longer by their expansion: 12e-6 of their length and kelvin."""

    def alter(net, deviations, nodes, random):
        deviations += 12e-6 * by * np.array(net.data["unstressed_lengths"])
        return set()

    return alter


def moved_supports(count, by):
    def alter(net, deviations, nodes, random):
        moved = random.choice(net.data["supports"], count, replace=False)
        for node in moved:
            direction = random.normal(size=3)
            nodes[node] += by * direction / np.linalg.norm(direction)
        return {("support", node) for node in moved.tolist()}

    return alter


def shifted(by):
    def alter(net, deviations, nodes, random):
        deviations[net.interior] += by
        return set()

    return alter


def softer(part):
    """EA of all edges lower by a part."""

    def alter(net, deviations, nodes, random):
        net.stiffness = np.array(net.data["axial_stiffness"]) * (1 - part)
        return set()

    return alter


def heavier(part):
    """Loads of all nodes, not self-weight, larger by a part."""

    def alter(net, deviations, nodes, random):
        net.load_factor = 1 + part
        return set()

    return alter


def loaded(by):
    """More load at each free node than given [N]."""

    def alter(net, deviations, nodes, random):
        net.missing_load = by
        return set()

    return alter


def softer_group(part):
    """EA of the cables of one direction lower by a part."""

    def alter(net, deviations, nodes, random):
        way = np.abs(net.nodes[net.edges[:, 0]] - net.nodes[net.edges[:, 1]])
        factor = np.where(way[:, 0] > way[:, 1], 1 - part, 1.0)
        net.stiffness = np.array(net.data["axial_stiffness"]) * factor
        return set()

    return alter


def bedding_in(part):
    """Cables that are softer by a part where they are slack, and as given at their nominal tension."""

    def alter(net, deviations, nodes, random):
        stiffness = np.array(net.data["axial_stiffness"])
        strain = np.maximum(net.spans(net.nodes) / np.array(net.data["unstressed_lengths"]) - 1, 1e-5)
        at = np.linspace(0, 2, 9)
        net.data["tension_laws"] = [
            {"name": f"edge {e}", "strain": (s * at).tolist(), "tension": (s * k * at * (1 - part + part * at)).tolist()}
            for e, (s, k) in enumerate(zip(strain, stiffness))]
        net.data["tension_law"] = list(range(len(net.edges)))
        return set()

    return alter


def turned(std):
    """All turnbuckles, by strokes that nobody tells."""

    def alter(net, deviations, nodes, random):
        deviations[net.adjustable] += std * random.normal(size=len(net.adjustable))
        return set()

    return alter


def moved_frame(by):
    """Supports along z: by(place along x, from 0 to 1)."""

    def alter(net, deviations, nodes, random):
        supports = net.data["supports"]
        x = net.nodes[supports, 0]
        nodes[supports, 2] += by((x - x.min()) / np.ptp(x))
        return set()

    return alter


def swapped():
    """Two interior edges at a node have each other's length; their lengths differ by 10 mm or more."""

    def alter(net, deviations, nodes, random):
        lengths = np.array(net.data["unstressed_lengths"])
        pairs = []
        for node in net.free:
            at = [e for e in np.flatnonzero((net.edges == node).any(axis=1)) if e in net.interior]
            pairs += [(a, b) for a in at for b in at if a < b and 0.01 < abs(lengths[a] - lengths[b]) < 0.04]
        a, b = pairs[random.integers(len(pairs))]
        deviations[[a, b]] += lengths[b] - lengths[a], lengths[a] - lengths[b]
        return {("edge", int(a)), ("edge", int(b))}

    return alter


def two_stations(by):
    """Places beyond the middle of x are off by so much in all."""
    return lambda place, random: place + by * (place[0] > 0) * np.array([0.6, 0, 0.8])


def straight_pairs(net, node, edges):
    """Those edges of a node that go straight on through it, two and two."""
    way = {e: net.nodes[net.edges[e]].sum(axis=0) - 2 * net.nodes[node] for e in edges if node in net.edges[e]}
    return [(a, b) for a in way for b in way
            if a < b and way[a] @ way[b] < -0.9 * np.linalg.norm(way[a]) * np.linalg.norm(way[b])]


def scaled_runs(std):
    """Each cable, straight through its nodes, has a scale of its own."""

    def alter(net, deviations, nodes, random):
        run = np.arange(len(net.edges))
        for node in net.free:
            for a, b in straight_pairs(net, node, range(len(net.edges))):
                run[run == run[b]] = run[a]
        scale = std * random.normal(size=len(net.edges))[run]
        deviations[net.interior] += (scale * np.array(net.data["unstressed_lengths"]))[net.interior]
        return set()

    return alter


def slipped(by):
    """A clamp: of two interior edges at a node that go on straight one is longer, the other shorter."""

    def alter(net, deviations, nodes, random):
        while True:
            pairs = straight_pairs(net, random.choice(net.free), net.interior.tolist())
            if pairs:
                a, b = pairs[random.integers(len(pairs))]
                deviations[[a, b]] += by, -by
                return {("edge", a), ("edge", b)}

    return alter


def drifting(by):
    """A survey that drifts by so much over 10 m along x."""
    return lambda places, random: places + np.array([0, 0, by / 10.0]) * places[0]


def moved(shift=(0, 0, 0), scale=1.0):
    return lambda places, random: scale * places + np.array(shift)


def of_net(net, prior, name, where="", **more):
    """A case of another net, with the prior given; its name begins with both."""
    return Case(f"{net}{where}, {prior}: {name}", truth=prior, given=prior, net=net, **more)


CASES = [
    Case("nothing is wrong"),
    Case("nothing is wrong, the prior given", given="uniform:5mm"),
    Case("five cables 15 mm too long", alter=off("interior", 5, 0.015), suspects=5),
    Case("five cables 15 mm too long, the prior given", given="uniform:5mm", alter=off("interior", 5, 0.015), suspects=5),
    of_net("hypar:9x9", "uniform:2mm", "a cable 15 mm too long", alter=off("interior", 1, 0.015), suspects=1),
    of_net("hypar:9x9", "uniform:2mm", "three cables 15 mm too long", alter=off("interior", 3, 0.015), suspects=3),
    of_net("steel-roof", "uniform:2mm", "nothing is wrong"),
    of_net("hypar:9x9", "uniform:15mm", "nothing is wrong, some edges are slack"),
    of_net("hypar:9x9", "uniform:15mm", "all turnbuckles 1 mm too long, some edges are slack", alter=off("adjustable", None, 0.001)),
    *[of_net(f"hypar:{n}x{n}", "uniform:1mm", "nothing is wrong") for n in (20, 28, 40, 160)],
    of_net("steel-roof", "uniform:2mm", "30 K warmer", alter=warmer(30.0)),
    *[of_net("steel-roof", "uniform:2mm", f"loads {part} % heavier", alter=heavier(part / 100)) for part in (5, 10)],
    *[of_net("hypar:9x9", "uniform:2mm", name, " under 200 N at each node", hangs=200.0, alter=heavier(percent / 100), options=options)
      for name, percent, options in [("nothing is wrong", 0, ()), *[(f"loads {p} % heavier", p, ()) for p in (5, 10, 20)],
                                     ("loads 5 % heavier, --uncertain none", 5, ("--uncertain", "none"))]],
    Case("20 N at each node not given", given="uniform:5mm", alter=loaded(20.0)),
    of_net("hypar:5x5", "uniform:2mm", "50 N at each node not given", alter=loaded(50.0)),
    Case("lengths uniform:7mm", truth="uniform:7mm", given="uniform:5mm"),
    Case("lengths normal:2.9mm", truth="normal:2.9mm", given="uniform:5mm"),
    Case("lengths bimodal:4mm", truth="bimodal:4mm", given="uniform:5mm"),
    Case("lengths 3 mm too long in common", given="uniform:5mm", alter=shifted(0.003)),
    Case("lengths uniform:5mm given uniform:3.5mm", given="uniform:3.5mm"),
    Case("lengths uniform:5mm given uniform:2.5mm", given="uniform:2.5mm"),
    Case("lengths uniform:5mm given uniform:1.67mm", given="uniform:1.67mm"),
    Case("lengths normal:2.9mm, no prior given", truth="normal:2.9mm"),
    Case("lengths uniform:7mm, no prior given", truth="uniform:7mm"),
    Case("lengths uniform:2mm, no prior given", truth="uniform:2mm"),
    *[Case(f"{net}: {prior or 'no prior'} given, lengths {truth}", truth=truth, given=prior, net=net)
      for net, prior, truth in [("hypar:5x5", None, "uniform:2mm"), ("hypar:5x5", None, "uniform:3mm"),
                                ("hypar:9x9", None, "uniform:3mm"), ("hypar:5x5", "uniform:2mm", "uniform:2.4mm"),
                                ("hypar:9x9", "uniform:2mm", "uniform:2.4mm"), ("hypar:5x5", "uniform:2mm", "uniform:3mm"),
                                ("hypar:5x5", "uniform:4mm", "uniform:2mm")]],
    *[Case(f"{text} not given", given="uniform:5mm", uncertain=[text])
      for text in ["stiffness:10%", "stiffness-each:5%", "temperature:20K", "adjustable:0.5mm", "supports:1mm"]],
    Case("EA 10 % lower", given="uniform:5mm", alter=softer(0.1)),
    *[of_net("hypar:9x9", "uniform:2mm", name, alter=alter)
      for name, alter in [("nothing is wrong", None), ("EA 10 % lower", softer(0.1)), ("20 K warmer", warmer(20.0)),
                          ("all lengths 0.7 mm too long", shifted(0.0007)), ("a scale of 0.5 % of each cable", scaled_runs(0.005))]],
    of_net("hypar:5x5", "uniform:2mm", "nothing is wrong"),
    Case("hypar:5x5: uniform:0.2mm given, lengths uniform:3mm", truth="uniform:3mm", given="uniform:0.2mm", net="hypar:5x5"),
    Case("a clamp slipped by 10 mm", given="uniform:5mm", alter=slipped(0.01), suspects=2),
    of_net("hypar:9x9", "uniform:2mm", "a clamp slipped by 10 mm", alter=slipped(0.01), suspects=2),
    Case("two cables swapped", given="uniform:5mm", alter=swapped(), suspects=2),
    Case("EA of one direction 10 % lower", given="uniform:5mm", alter=softer_group(0.1)),
    Case("cables bed in", given="uniform:5mm", alter=bedding_in(0.3)),
    Case("all turnbuckles 1 mm too long", given="uniform:5mm", alter=off("adjustable", None, 0.001)),
    Case("24 turnbuckles 30 mm too long", given="uniform:5mm", alter=off("adjustable", 24, 0.03), suspects=24),
    Case("turns that are not given, 5 mm", given="uniform:5mm", alter=turned(0.005)),
    Case("the frame bends by 1 mm", given="uniform:5mm", alter=moved_frame(lambda x: 0.004 * x * (1 - x))),
    Case("one side of the frame 2 mm off", given="uniform:5mm", alter=moved_frame(lambda x: 0.002 * (x > 0.9))),
    *[of_net("hypar:9x9", "uniform:2mm", name, alter=alter, **more)
      for name, alter, more in [
          ("EA of one direction 10 % lower", softer_group(0.1), {}), ("EA 10 % lower, five load cells", softer(0.1), {"cells": 5}),
          *[(f"five load cells{more}", None, {"cells": 5, "cells_off": off})
            for more, off in [("", 0.0), (", all 15 % too high", 0.15), (", all 30 % too high", 0.3)]],
          *[(f"two load cells{more}", None, {"cells": 2, "cells_off": off})
            for more, off in [("", 0.0), (", one 40 % too low", (-0.4, 0)), (", one 70 % too low", (-0.7, 0)),
                              (", one 50 % too high", (0.5, 0))]],
          ("cables bed in", bedding_in(0.3), {}), ("all turnbuckles 1 mm too long", off("adjustable", None, 0.001), {}),
          ("turns that are not given, 5 mm", turned(0.005), {}),
          ("the frame bends by 1 mm", moved_frame(lambda x: 0.004 * x * (1 - x)), {}),
          ("one side of the frame 2 mm off", moved_frame(lambda x: 0.002 * (x > 0.9)), {}),
          ("two stations 0.5 mm apart", None, {"survey": two_stations(0.0005)}),
          ("survey drifts by 0.5 mm in 10 m", None, {"survey": drifting(0.0005)})]],
    Case("two stations 0.5 mm apart", given="uniform:5mm", survey=two_stations(0.0005)),
    Case("survey drifts by 0.5 mm in 10 m", given="uniform:5mm", survey=drifting(0.0005)),
    of_net("hypar:8x8", "uniform:3mm", "x and y exchanged", frame=None, survey=lambda place, random: place[[1, 0, 2]]),
    Case("noise given three times too small", given="uniform:5mm", given_noise="0.1667mm"),
    Case("noise given 1.5 times too small", given="uniform:5mm", given_noise="0.333mm"),
    Case("noise given two times too large", given="uniform:5mm", given_noise="1mm"),
    Case("noise 0.3, 0.3 and 1.2 mm along x, y and z, given 0.6 mm", given="uniform:5mm", noise="0.6mm", by_axis=(0.5, 0.5, 2)),
    of_net("hypar:9x9", "uniform:2mm", "noise 0.3, 0.3 and 1.2 mm along x, y and z, given 0.6 mm", noise="0.6mm", by_axis=(0.5, 0.5, 2)),
    *[Case(f"hypar:9x9, uniform:2mm{more}: noise 1.5, 1.5 and 0.5 mm along x, y and z, given 0.5 mm", truth="uniform:2mm", given=given,
           net="hypar:9x9", by_axis=(3, 3, 1)) for more, given in [("", "uniform:2mm"), (", no prior given", None)]],
    Case("noise not known, --noise estimate", given="uniform:5mm", given_noise="estimate"),
    Case("noise with heavy tails", given="uniform:5mm", heavy=True),
    Case("survey 3 mm off as a whole, --frame net", given="uniform:5mm", survey=moved((0.003, 0, 0))),
    Case("survey 10 mm off as a whole", given="uniform:5mm", survey=moved((0.006, -0.008, 0)), frame=None),
    Case("survey 3 mm off as a whole", given="uniform:5mm", survey=moved((0.003, 0, 0)), frame=None),
    Case("a turnbuckle 3 mm off", given="uniform:5mm", alter=off("adjustable", 1, 0.003), suspects=1),
    Case("a turnbuckle 8 mm off", given="uniform:5mm", alter=off("adjustable", 1, 0.008), suspects=1),
    Case("30 turnbuckles 3 mm off", given="uniform:5mm", alter=off("adjustable", 30, 0.003), suspects=30),
    Case("a support 10 mm off", given="uniform:5mm", alter=moved_supports(1, 0.01), suspects=1),
    Case("all supports 2 mm off", given="uniform:5mm", alter=moved_supports(128, 0.002)),
    Case("all supports 2 mm off, given", given="uniform:5mm", alter=moved_supports(128, 0.002),
         options=["--uncertain", "supports:1.2mm"]),
    Case("survey scaled by 1.001", given="uniform:5mm", survey=moved(scale=1.001), frame=None),
    Case("survey scaled by 1.001, --frame net", given="uniform:5mm", survey=moved(scale=1.001)),
]


def ends_of(net, suspect):
    """The nodes that have to be seen for it to show."""
    kind, index = suspect
    edges = net.edges[[index]] if kind == "edge" else net.edges[(net.edges == index).any(axis=1)]
    return set(edges.ravel().tolist())


def try_survey(net, case, folder, seed):
    suspects = set()

    def alter(deviations, nodes, random):
        if case.alter:
            suspects.update(case.alter(net, deviations, nodes, random))

    net.alter = alter
    form, tension, deviations, _ = net.build(case.truth, case.uncertain, seed)
    random = np.random.default_rng(10_000 + seed)

    def place(node):
        measured = form[node] + case.error(random)
        return case.survey(measured, random) if case.survey else measured

    seen = write_survey(folder / "survey.csv", net.free, place, random)
    words = ["--noise", case.given_noise, *case.options, "--draws", "100"]
    if case.cells:
        rows = [f"{edge},{tension[edge] * (1 + off) * (1 + 0.02 * random.normal())}"
                for edge, off in zip(random.choice(len(tension), case.cells, replace=False), case.cells_off)]
        (folder / "forces.csv").write_text("edge,tension\n" + "\n".join(rows) + "\n")
        words += ["--forces", folder / "forces.csv"]
    words += ["--frame", case.frame] if case.frame else []
    words += ["--prior", case.given] if case.given else []
    result, _ = identify(folder, *words)
    if not result:
        return {"said": "refused", "why": "refused"}
    inside = [holds(e, deviations[e["edge"]]) for e in result["edges"]]
    given = [e for e in result["edges"] + result["adjustable_edges"] if e["tension"] is not None]
    tight = [holds(e, tension[e["edge"]], "tension_") for e in given]
    errors = [e["length_deviation"] - deviations[e["edge"]] for e in result["edges"]]
    found = result["diagnostics"]
    named = {("edge", e["edge"]) for e in found["length_outliers"]}
    confounded = {e["node"] for e in found["length_outliers"]
                  if e.get("beside_target") and ("edge", e["edge"]) in suspects}
    false_alarms = len(named - suspects) + sum(o["id"] not in confounded for o in result["survey"]["outliers"])
    for entry in found["boundary"]:
        false_alarms += not either_of(entry) & suspects
        named |= either_of(entry)
    known = seen | set(net.data["supports"])
    shown = {one for one in suspects if ends_of(net, one) <= known}
    return {
        "said": result["trust"]["verdict"],
        "why": result["findings"][0]["kind"] if result["findings"] else "",
        "inside": np.mean(inside),
        "tight": np.mean(tight) if tight else None,
        "error": rms(errors),
        "shown": len(shown),
        "named": len(named & shown),
        "false_alarms": false_alarms,
    }


def row(case, surveys):
    with temporary_folder() as folder:
        net = Net(case.net, folder, load=case.hangs)
        if len(net.edges) > 5000:
            surveys //= 10
        elif not case.net.startswith("hypar"):  # the others are larger
            surveys = 2 * surveys // 5
        tried = [try_survey(net, case, folder, seed) for seed in range(surveys)]
    given = [one for one in tried if "inside" in one]
    said = ", ".join(f"{name} {count}" for name, count in Counter(one["said"] for one in tried).most_common())
    silent = sum(one["said"] == "passed" and min(one["inside"], one["tight"] or 1.0) < 0.85 for one in given)
    why = Counter(one["why"] for one in tried if one["why"])
    inside = percent([one["inside"] for one in given])
    tensions = percent([one["tight"] for one in given if one["tight"] is not None])
    error = f"{1e3 * rms([one['error'] for one in given]):.2f}" if given else "-"
    named = f"{sum(one['named'] for one in given)} of {sum(one['shown'] for one in given)}" if case.suspects else "-"
    false_alarms = sum(one["false_alarms"] for one in given)
    return (f"| {case.name} | {inside} | {tensions} | {error} | {named} | {false_alarms} | {said} | {silent} | "
            f"{why.most_common(1)[0][0] if why else ''} |")


def rows_of_page():
    """The rows of the table as it stands, by their case."""
    page = (DOCS / "diagnostics.md").read_text(encoding="utf-8")
    return {line.split(" | ")[0].removeprefix("| "): line for line in page.splitlines() if line.startswith("| ")}


def lines():
    words = [word for word in sys.argv[1:] if word != "--write"]
    surveys = int(words[0]) if words else SURVEYS
    wanted = words[1] if len(words) > 1 else ""
    kept = rows_of_page() if wanted and "--write" in sys.argv else {}
    yield by(__file__, f", {2 * surveys // 5} surveys a row, {surveys} on a hypar, {surveys // 10} on one of more than 5000 edges "
                       "(`--write 50 CASE` makes the rows of some cases anew)")
    yield from heading("what is wrong | lengths inside [%] | tensions inside [%] | RMSE [mm] | suspects right | false alarms | verdict | "
                       "passed below 85 % | the worst finding, most often")
    made = [case for case in CASES if wanted in case.name or case.name in kept]
    with ThreadPoolExecutor(2) as pool:
        yield from pool.map(lambda case: row(case, surveys) if wanted in case.name else kept[case.name], made)


if __name__ == "__main__":
    show("diagnostics.md", __file__, lines())
