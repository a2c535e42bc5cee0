# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Simulated nets and surveys for the studies of docs/, and what `taut identify` makes of them.

Lengths and all other uncertain quantities are drawn here, and tensions follow from EA (l / l_0 - 1), or from the
tension law. Only the form of each net is `taut form`'s.
"""

import contextlib
import csv
import json
import pathlib
import subprocess
import tempfile

import numpy as np

UNITS = {"mm": 1e-3, "N": 1.0, "K": 1.0, "%": 1e-2}


def taut(*words):
    return subprocess.run(["taut", *map(str, words)], capture_output=True, text=True)


@contextlib.contextmanager
def temporary_folder():
    with tempfile.TemporaryDirectory() as name:
        yield pathlib.Path(name)


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


def spans(edges, form):
    return np.linalg.norm(form[edges[:, 0]] - form[edges[:, 1]], axis=1)


def read_form(path, nodes):
    """Places of a form file; those of nodes that it lacks are the given ones."""
    form = nodes.copy()
    for row in csv.DictReader(path.open()):
        form[int(row["id"])] = [float(row[axis]) for axis in "xyz"]
    return form


def write_points(path, nodes, places):
    path.write_text("".join(f"{node}," + ",".join(map(repr, map(float, place))) + "\n" for node, place in zip(nodes, places)))


def write_survey(path, nodes, place_of, random, hidden=0.1, shown=None):
    """Writes the measured places of nodes, a part of them hidden, but for one. Returns the nodes that are not."""
    seen = {}
    for node in nodes.tolist():
        place = place_of(node)
        if random.random() >= hidden or node == shown:
            seen[node] = place
    write_points(path, seen, seen.values())
    return set(seen)


def identify(folder, *words, survey="survey.csv", net="net.json"):
    """Result of a net and a survey of the folder, None where there is none; and how the program ended."""
    path = folder / "result.json"
    path.unlink(missing_ok=True)
    ended = taut("identify", folder / net, folder / survey, *words, "--quiet", "-o", path)
    return (json.loads(path.read_text()) if path.exists() else None), ended


def holds(entry, truth, prefix=""):
    """Whether an interval contains the truth."""
    return entry[prefix + "lower"] - 1e-9 <= truth <= entry[prefix + "upper"] + 1e-9


def either_of(entry):
    """What an entry of the boundary names: an edge or a support, with what it is confounded with."""
    kind, other = ("edge", "support") if "edge" in entry else ("support", "edge")
    named = {(kind, entry.get("edge", entry.get("node")))}
    return named if entry["confounded_with"] is None else named | {(other, int(entry["confounded_with"]))}


def percent(values):
    return f"{100 * np.mean(values):.1f}" if len(values) else "-"


def rms(values):
    return np.sqrt(np.mean(np.square(values)))


def verdict_counts(counts):
    return ", ".join(f"{counts[word]} {word}" for word in ("passed", "doubtful", "failed", "refused") if counts[word])


class Count:
    """How many intervals contain the truth, in percent."""

    def __init__(self):
        self.inside = self.all = 0

    def add(self, truth, entry, prefix=""):
        self.inside += holds(entry, truth, prefix)
        self.all += 1

    def add_estimate(self, truth, mean, std):
        self.add(truth, {"lower": mean - 1.96 * std, "upper": mean + 1.96 * std})

    def __str__(self):
        return f"{100 * self.inside / self.all:.1f}" if self.all else "-"


class Net:
    """A net of `taut example`, under a load at each free node [N]. alter(deviations, nodes, random) builds it otherwise
    than designed."""

    def __init__(self, name, folder, factor=1, load=0.0):
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
            data["nodes"] = read_form(folder / "built.csv", np.array(data["nodes"], float)).tolist()
        self.nodes = np.array(data["nodes"], float)
        self.stiffness = np.broadcast_to(np.array(data["axial_stiffness"], float), count).copy()
        self.lengths = np.array(data["unstressed_lengths"], float)
        at_supports = np.isin(self.edges, data["supports"]).any(axis=1)
        self.adjustable = np.array(data.get("adjustable", np.flatnonzero(at_supports)))
        self.interior = np.setdiff1d(np.arange(count), self.adjustable)
        self.is_strut = np.array(data.get("kind", ["cable"] * count)) == "strut"
        self.load_factor, self.missing_load, self.stiffness_factor = 1.0, 0.0, 1.0
        self.options = []  # of taut identify, besides those of a study
        self.alter = lambda deviations, nodes, random: None
        self.expansion = np.array(data.setdefault("expansion", [1.2e-5] * count))
        strain = self.spans(self.nodes) / self.lengths - 1
        if factor != 1:
            self.lengths = self.spans(self.nodes) / (1 + strain / factor)
            self.stiffness *= factor
        data.update(unstressed_lengths=self.lengths.tolist(), axial_stiffness=self.stiffness.tolist())
        self.folder = folder
        self.give(data)

    def give(self, data):
        """Writes the net that taut gets."""
        (self.folder / "net.json").write_text(json.dumps(data))

    def spans(self, form):
        return spans(self.edges, form)

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
        """A net as it might be built: its form, tensions, length deviations and uncertain parameters."""
        random = np.random.default_rng(seed)
        count, nodes = len(self.edges), self.nodes.copy()
        factor, lengths, loads, truth = np.full(count, self.stiffness_factor), self.lengths.copy(), self.loads.copy(), {}
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
        if "tension_law" in built:
            laws = [self.data["tension_laws"][law] for law in built["tension_law"]]  # all have one
            built["tension_laws"] = [dict(law, tension=(by * np.array(law["tension"])).tolist()) for law, by in zip(laws, factor)]
            built["tension_law"] = list(range(count))
        lengths = (lengths + deviations) * (1 + self.expansion * truth.get("temperature", 0.0))
        built["unstressed_lengths"] = lengths.tolist()
        (self.folder / "built.json").write_text(json.dumps(built))
        done = taut("form", self.folder / "built.json", "-o", self.folder / "built.csv")
        if done.returncode != 0:
            raise RuntimeError(f"seed {seed}: {done.stderr}")
        form = read_form(self.folder / "built.csv", nodes)
        return form, self.tensions(form, lengths, factor), deviations, truth
