# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Counts how often the truth lies in the 95 % intervals of `taut identify`: the table of docs/validation.md.

Nets are built by code of this file alone: lengths and all else that is uncertain are drawn here, and tensions follow
from EA (l / l_0 - 1), or from the tension law. Only the form of each net is `taut form`'s.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/coverage.py --write
"""

import csv
import json
import pathlib
import subprocess
import tempfile

import numpy as np
from page_block import show

UNKNOWNS = ["stiffness:5%", "supports:1mm", "temperature:15K", "adjustable:0.5mm", "loads:20N"]
UNITS = {"mm": 1e-3, "N": 1.0, "K": 1.0, "%": 1e-2}

# net, factor of its stiffness at the same tensions, prior, noise, hidden, surveys, uncertain, load cells
CASES = [
    ("hilo-quarter", 1, "uniform:5mm", "0.5mm", "10%", 50, [], 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, [], 0),
    ("hypar:9x9", 1, "normal:2mm", "2mm", "10%", 200, [], 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, UNKNOWNS, 0),
    ("hypar:9x9", 1, "uniform:2mm", "0.5mm", "10%", 200, [*UNKNOWNS, "stiffness-each:3%"], 5),
    ("hypar:9x9", 10, "uniform:0.5mm", "0.5mm", "10%", 100, [], 5),
    ("hypar:9x9", 10, "uniform:2mm", "0.5mm", "10%", 50, [], 5),
    ("hypar:9x9", 1, "uniform:15mm", "0.5mm", "10%", 20, [], 0),
    ("steel-roof", 1, "uniform:5mm", "0.5mm", "10%", 50, [], 0),
    ("steel-roof", 1, "uniform:2mm", "0.5mm", "10%", 50, [], 0),
]
CELL_NOISE = 0.02


def taut(*words):
    return subprocess.run(["taut", *map(str, words)], capture_output=True, text=True)


def quantity(text):
    unit = next(unit for unit in UNITS if text.endswith(unit))
    return float(text.removesuffix(unit)) * UNITS[unit]


def drawn(prior, count, random):
    """Deviations of lengths."""
    kind, scale = prior.split(":")
    if kind == "uniform":
        return quantity(scale) * random.uniform(-1, 1, count)
    if kind == "bimodal":
        return quantity(scale) * (random.choice([-1, 1], count) + 0.2 * random.normal(size=count))
    return quantity(scale) * random.normal(size=count)


class Net:
    """A net of `taut example`, under a load at each free node [N]; alter(deviations, nodes, random) builds it otherwise than designed."""

    def __init__(self, name, factor, folder, alter=None, load=0.0):
        taut("example", name, "-o", folder / "net.json")
        self.data = json.loads((folder / "net.json").read_text())
        data = self.data
        self.edges = np.array(data["edges"])
        count = len(self.edges)
        self.free = np.setdiff1d(np.arange(len(data["nodes"])), data["supports"])
        self.loads = np.array(data.get("loads") or np.zeros((len(data["nodes"]), 3)), float)
        if load:
            self.loads[self.free, 2] -= load
            data["loads"] = self.loads.tolist()
            (folder / "net.json").write_text(json.dumps(data))
            taut("form", folder / "net.json", "-o", folder / "built.csv")
            data["nodes"] = self.form_of(folder, np.array(data["nodes"], float)).tolist()
        self.nodes = np.array(data["nodes"], float)
        self.stiffness = np.broadcast_to(np.array(data["axial_stiffness"], float), count).copy()
        self.lengths = np.array(data["unstressed_lengths"], float)
        at_supports = np.isin(self.edges, data["supports"]).any(axis=1)
        self.adjustable = np.array(data.get("adjustable", np.flatnonzero(at_supports)))
        self.interior = np.setdiff1d(np.arange(count), self.adjustable)
        self.is_strut = np.array(data.get("kind", ["cable"] * count)) == "strut"
        self.load_factor, self.missing_load = 1.0, 0.0
        self.alter = alter or (lambda deviations, nodes, random: None)
        self.expansion = np.array(data.setdefault("expansion", [1.2e-5] * count))
        strain = self.spans(self.nodes) / self.lengths - 1
        if factor != 1:
            self.lengths = self.spans(self.nodes) / (1 + strain / factor)
            self.stiffness *= factor
        data["unstressed_lengths"] = self.lengths.tolist()
        data["axial_stiffness"] = self.stiffness.tolist()
        (folder / "net.json").write_text(json.dumps(data))
        self.folder = folder

    @staticmethod
    def form_of(folder, nodes):
        form = nodes.copy()
        for row in csv.DictReader((folder / "built.csv").open()):
            form[int(row["id"])] = [float(row[axis]) for axis in "xyz"]
        return form

    def spans(self, form):
        return np.linalg.norm(form[self.edges[:, 0]] - form[self.edges[:, 1]], axis=1)

    def tensions(self, form, lengths, factor):
        strain = self.spans(form) / lengths - 1
        strain = np.where(self.is_strut, strain, np.maximum(strain, 0))
        result = self.stiffness * factor * strain
        for edge, law in enumerate(self.data.get("tension_law") or []):
            if law is not None:
                points = self.data["tension_laws"][law]
                x, y = np.array(points["strain"]), np.array(points["tension"])
                beyond = max(0.0, strain[edge] - x[-1]) * (y[-1] - y[-2]) / (x[-1] - x[-2])
                result[edge] = factor[edge] * (np.interp(strain[edge], x, y) + beyond)
        return result

    def build(self, prior, uncertain, seed):
        """A net as it might be built: its form, tensions, length deviations and uncertain."""
        random = np.random.default_rng(seed)
        count, nodes = len(self.edges), self.nodes.copy()
        factor, lengths, loads, truth = np.ones(count), self.lengths.copy(), self.loads.copy(), {}
        for text in uncertain:
            name, width = text.split(":")
            std = quantity(width)
            if name in ("stiffness", "stiffness-each"):
                truth[name] = std * random.normal(size=count if name.endswith("each") else None)
                factor = factor * np.exp(truth[name])
            elif name == "temperature":
                truth[name] = std * random.normal()
            elif name == "supports":
                truth[name] = std * random.normal(size=nodes.shape)
                nodes[self.data["supports"]] += truth[name][self.data["supports"]]
            elif name == "adjustable":
                truth[name] = std * random.normal(size=count)
                lengths[self.adjustable] += truth[name][self.adjustable]
            elif name == "loads":
                truth[name] = std * random.normal(size=nodes.shape)
                loads[self.free] += truth[name][self.free]
        deviations = np.zeros(count)
        deviations[self.interior] = drawn(prior, len(self.interior), random)
        self.alter(deviations, nodes, random)
        loads *= self.load_factor
        loads[self.free, 2] -= self.missing_load
        built = dict(self.data, nodes=nodes.tolist(), loads=loads.tolist(), adjustable=self.adjustable.tolist())
        built["axial_stiffness"] = (self.stiffness * factor).tolist()
        lengths = (lengths + deviations) * (1 + self.expansion * truth.get("temperature", 0.0))
        built["unstressed_lengths"] = lengths.tolist()
        (self.folder / "built.json").write_text(json.dumps(built))
        done = taut("form", self.folder / "built.json", "-o", self.folder / "built.csv")
        if done.returncode != 0:
            raise RuntimeError(f"seed {seed}: {done.stderr}")
        form = self.form_of(self.folder, nodes)
        return form, self.tensions(form, lengths, factor), deviations, truth


class Count:
    def __init__(self):
        self.inside = self.all = 0

    def add(self, truth, entry, prefix=""):
        self.inside += entry[prefix + "lower"] - 1e-9 <= truth <= entry[prefix + "upper"] + 1e-9
        self.all += 1

    def __str__(self):
        return f"{100 * self.inside / self.all:.1f}" if self.all else "-"


def truth_of(parameter, truth):
    values = truth[parameter["name"]]
    if "edge" in parameter:
        return values[parameter["edge"]]
    if "node" in parameter:
        return values[parameter["node"]]["xyz".index(parameter["axis"])]
    return values


def row(case, folder):
    name, factor, prior, noise, hidden, surveys, uncertain, cells = case
    net = Net(name, factor, folder)
    lengths, slack, tensions, means, places, numbers = (Count() for _ in range(6))
    errors, given, failed = [], 0, 0
    for seed in range(surveys):
        form, tension, deviations, truth = net.build(prior, uncertain, seed)
        random = np.random.default_rng(10_000 + seed)
        with (folder / "survey.csv").open("w") as out:
            for node in net.free:
                place = form[node] + quantity(noise) * random.normal(size=3)
                if random.random() >= quantity(hidden):
                    out.write(f"{node}," + ",".join(map(repr, map(float, place))) + "\n")
        command = ["identify", folder / "net.json", folder / "survey.csv", "--noise", noise, "--frame", "net"]
        command += ["--prior", prior, "--quiet", "-o", folder / "result.json"]
        for parameter in ["none", *uncertain]:
            command += ["--uncertain", parameter]
        if cells:
            read = random.choice(np.flatnonzero(tension > 0), cells, replace=False)
            lines = [f"{e},{tension[e] * (1 + CELL_NOISE * random.normal())}\n" for e in read]
            (folder / "forces.csv").write_text("".join(lines))
            command += ["--forces", folder / "forces.csv", "--force-noise", f"{100 * CELL_NOISE:g}%"]
        failed += taut(*command).returncode != 0
        if not (folder / "result.json").exists():
            continue
        result = json.loads((folder / "result.json").read_text())
        (folder / "result.json").unlink()
        for edge in result["edges"]:
            (slack if edge["status"] == "slack" else lengths).add(deviations[edge["edge"]], edge)
        for parameter in result["uncertain"]:
            value, half = truth_of(parameter, truth), 1.96 * parameter["std"]
            numbers.add(value, {"lower": parameter["mean"] - half, "upper": parameter["mean"] + half})
        if not result["mean_tension"]:
            continue
        given += 1
        for edge in result["edges"] + result["adjustable_edges"]:
            tensions.add(tension[edge["edge"]], edge, "tension_")
        means.add(tension.mean(), result["mean_tension"])
        errors.append(result["mean_tension"]["mean"] / tension.mean() - 1)
        for place in result["missing_places"]:
            for axis in range(3):
                bounds = {"lower": place["lower"][axis], "upper": place["upper"][axis]}
                places.add(form[place["node"]][axis], bounds)
    rms = f"{100 * np.sqrt(np.mean(np.square(errors))):.2f} %" if errors else "-"
    of_net = f"`{name}`" + (f", {factor} times as stiff" if factor != 1 else "")
    of_uncertain = ", ".join(uncertain) or "none"
    return (
        f"| {of_net} | {prior}, {noise}, {hidden} | {of_uncertain} | {cells or 'none'} | {surveys}, {failed}, {given} | {lengths} | "
        f"{slack} | {tensions} | {places} | {numbers} | {means}, {rms} |"
    )


def lines():
    yield "By `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/coverage.py --write`:\n"
    yield ("| net | prior, noise, hidden | uncertain | cells | surveys, failed, with tensions | lengths | slack | tensions | places "
           "| parameters | mean tension, error |")
    yield "|" + "---|" * 11
    for case in CASES:
        with tempfile.TemporaryDirectory() as folder:
            yield row(case, pathlib.Path(folder))


if __name__ == "__main__":
    show("validation.md", "benchmarks/coverage.py", lines())
