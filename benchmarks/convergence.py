# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Convergence study: how many random surveys of soft, stiff and slack nets `taut identify --method map` converges on,
and how far its intervals and slack probabilities are right. Prints the tables of docs/validation.md,
"Convergence study"; draws a reliability diagram.

    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/convergence.py 84 docs/images/slack_reliability.svg > convergence.md

A survey follows from its net and its number: lengths are uniform to +-2 or +-5 mm; the standard deviation of a
coordinate is 0.05 to 2 mm, its logarithm uniform; none or a tenth of the free nodes hidden; none or 5 % of the targets
are off by 10 to 50 standard deviations. `taut form` and `taut survey` make them, with gross errors from here.
"""

import csv
import json
import pathlib
import resource
import sys

import numpy as np
from page_block import heading
from simulation import holds, identify, percent, read_form, rms, spans, taut, temporary_folder

THREADS = ("--threads", 2)
SURVEYS = 84
# name, example, factor of stiffness, factor of tensions; those that hang have the tensions of their loads alone
NETS = [
    ("hilo-quarter", "hilo-quarter", 1, 1),
    ("hilo-quarter, 10 x as stiff", "hilo-quarter", 10, 1),
    ("hilo-quarter, 100 x as stiff", "hilo-quarter", 100, 1),
    ("hypar:5x5", "hypar:5x5", 1, 1),
    ("hypar:9x9", "hypar:9x9", 1, 1),
    ("hypar:9x9, 10 x as stiff", "hypar:9x9", 10, 1),
    ("hypar:9x9, tension 1/50", "hypar:9x9", 1, 0.02),
    ("hypar:12x20", "hypar:12x20", 1, 1),
    ("hypar:12x20, 10 x as stiff", "hypar:12x20", 10, 1),
    ("hypar:20x20, 30 x as stiff", "hypar:20x20", 30, 1),
    ("hanging:10x10", "hanging", 1, 1),
    ("hanging:10x10, 10 x as stiff", "hanging", 10, 1),
]
BINS = [0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0]  # a first bin of probability 0 alone


def hang(data):
    """The net's topology on supports at one height: a dome upside down, by force densities of 600 N/m under 20 N a node."""
    nodes, edges = np.array(data["nodes"], float), np.array(data["edges"])
    free = np.setdiff1d(np.arange(len(nodes)), data["supports"])
    nodes[:, 2] = 0
    loads = np.zeros_like(nodes)
    loads[free, 2] = -20
    incidence = np.zeros((len(edges), len(nodes)))
    incidence[np.arange(len(edges)), edges[:, 0]] = 1
    incidence[np.arange(len(edges)), edges[:, 1]] = -1
    stiffness = 600 * incidence.T @ incidence
    fixed = data["supports"]
    nodes[free] = np.linalg.solve(stiffness[np.ix_(free, free)], loads[free] - stiffness[np.ix_(free, fixed)] @ nodes[fixed])
    data.update(nodes=nodes.tolist(), loads=loads.tolist())
    return 600 * spans(edges, nodes)


class Net:
    def __init__(self, example, stiffer, tighter, folder):
        taut("example", "hypar:10x10" if example == "hanging" else example, "-o", folder / "net.json")
        data = json.loads((folder / "net.json").read_text())
        self.edges = np.array(data["edges"])
        stiffness = np.broadcast_to(np.array(data["axial_stiffness"], float), len(self.edges))
        if example == "hanging":
            tension = hang(data)
        else:
            tension = stiffness * (spans(self.edges, np.array(data["nodes"], float)) / data["unstressed_lengths"] - 1)
        self.nodes = np.array(data["nodes"], float)
        self.stiffness = stiffer * stiffness
        self.lengths = spans(self.edges, self.nodes) / (1 + tighter * tension / self.stiffness)
        data.update(axial_stiffness=self.stiffness.tolist(), unstressed_lengths=self.lengths.tolist())
        (folder / "net.json").write_text(json.dumps(data))
        self.folder, self.supports = folder, {str(node) for node in data["supports"]}

    def survey(self, number):
        """Writes survey.csv. Returns what it is of: prior, noise [mm], true length deviations and tensions."""
        random = np.random.default_rng([1, number])
        prior = f"uniform:{random.choice([2, 5])}mm"
        noise = np.exp(random.uniform(np.log(0.05), np.log(2)))
        hidden, gross = random.random(2) < 0.5
        for attempt in range(100):  # until the lengths find an equilibrium
            made = taut("form", self.folder / "net.json", "--prior", prior, "--seed", 1000 * number + attempt, "--lengths",
                        self.folder / "lengths.csv", "-o", self.folder / "form.csv", *THREADS)
            if made.returncode == 0:
                break
        else:
            sys.exit(f"survey {number}: 100 draws of lengths find no equilibrium: {made.stderr}")
        taut("survey", self.folder / "net.json", self.folder / "form.csv", "--noise", f"{noise}mm", "--drop",
             "10%" if hidden else "0%", "--seed", number, "-o", self.folder / "survey.csv", *THREADS)
        if gross:
            self.add_gross_errors(noise * 1e-3, random)
        form = read_form(self.folder / "form.csv", self.nodes)
        deviations = np.zeros(len(self.edges))
        for row in csv.DictReader((self.folder / "lengths.csv").open()):
            deviations[int(row["edge"])] = float(row["length_deviation"])
        strains = spans(self.edges, form) / (self.lengths + deviations) - 1
        return prior, noise, deviations, self.stiffness * np.maximum(strains, 0)

    def add_gross_errors(self, noise, random):
        path = self.folder / "survey.csv"
        with path.open() as file:
            rows = list(csv.DictReader(file))
        targets = [row for row in rows if row["id"] not in self.supports]
        for index in random.choice(len(targets), max(1, round(0.05 * len(targets))), replace=False):
            direction = random.normal(size=3)
            error = noise * random.uniform(10, 50) * direction / np.linalg.norm(direction)
            for axis, by in zip("xyz", error):
                targets[index][axis] = float(targets[index][axis]) + by
        with path.open("w") as out:
            writer = csv.DictWriter(out, rows[0])
            writer.writeheader()
            writer.writerows(rows)


def outcome_of(net, number):
    """What became of one survey, against the truth."""
    prior, noise, deviations, tension = net.survey(number)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result, ended = identify(net.folder, "--method", "map", "--prior", prior, "--prior-exact", "--noise", f"{noise}mm", "--frame", "net",
                             "--uncertain", "none", *THREADS)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    outcome = {"seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, "number": number,
               "message": ended.stderr.strip().splitlines()[-1] if ended.stderr.strip() else ""}
    outcome["converged"] = bool(result) and result["status"] == "converged"
    if not outcome["converged"]:
        return outcome
    edges = result["edges"]
    of_slack = [tension[e["edge"]] <= 0 for e in edges if e["status"] == "slack"]
    reported = [e for e in edges + result["adjustable_edges"] if e["tension"] is not None]
    outcome.update(
        inside=[holds(e, deviations[e["edge"]]) for e in edges],
        tensions=[holds(e, tension[e["edge"]], "tension_") for e in reported],
        called_slack=len(of_slack), wrongly=len(of_slack) - sum(of_slack),
        missed=sum(tension[e["edge"]] <= 0 for e in edges if e["status"] in ("determined", "weakly_determined")),
        slack=[(e["slack_probability"], tension[e["edge"]] <= 0) for e in reported])
    if result["mean_tension"]:
        outcome["mean_tension"] = result["mean_tension"]["mean"] / tension.mean() - 1
    return outcome


def row(name, outcomes):
    converged = [one for one in outcomes if one["converged"]]
    seconds = [one["seconds"] for one in outcomes]
    inside = [x for one in converged for x in one["inside"]]
    tensions = [x for one in converged for x in one["tensions"]]
    errors = [one["mean_tension"] for one in converged if "mean_tension" in one]
    error = f"{100 * rms(errors):.2f}" if errors else "-"
    slack = " | ".join(str(sum(one[key] for one in converged)) for key in ("called_slack", "wrongly", "missed"))
    return (f"| {name} | {len(outcomes)} | {len(converged)} | {np.median(seconds):.2f} | {max(seconds):.2f} | {percent(inside)} | "
            f"{percent([bool(one['tensions']) for one in converged])} | {percent(tensions)} | {error} | {slack} |")


def reliability(outcomes):
    """(bin, edges, their mean reported probability, the part of them that is slack)."""
    pairs = np.array([pair for one in outcomes if one["converged"] for pair in one["slack"]], float).reshape(-1, 2)
    chosen = np.searchsorted(BINS, pairs[:, 0])
    return [(f"{BINS[i - 1]:g} to {BINS[i]:g}" if i else "0", np.count_nonzero(chosen == i), *pairs[chosen == i].mean(axis=0))
            for i in range(len(BINS)) if np.any(chosen == i)]


def diagram(bins):
    """Edges that are slack against the reported probability, as SVG (Murphy and Winkler, Applied Statistics 26, 1977)."""
    size, margin = 360, 56
    width = size + 2 * margin

    def place(reported, found):
        return margin + reported * size, margin / 2 + (1 - found) * size

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {width}" width="{width}" height="{width}" '
             'font-family="sans-serif" font-size="13">', f'<rect width="{width}" height="{width}" fill="white"/>']
    for tick in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        (x, bottom), (left, y) = place(tick, 0.0), place(0.0, tick)
        parts.append(f'<path d="M{x:.1f} {bottom:.1f}V{bottom - size:.1f}M{left:.1f} {y:.1f}H{left + size:.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{x:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{100 * tick:.0f}</text>')
        parts.append(f'<text x="{left - 8:.1f}" y="{y + 4:.1f}" text-anchor="end">{100 * tick:.0f}</text>')
    (x0, y0), (x1, y1) = place(0, 0), place(1, 1)
    parts.append(f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke="#888" stroke-dasharray="5 4"/>')
    for _, edges, mean, part in bins:
        spread = np.sqrt(max(mean * (1 - mean), 1e-12) / edges)
        (x, y), (_, low), (_, high) = place(mean, part), place(mean, max(0, part - spread)), place(mean, min(1, part + spread))
        parts.append(f'<path d="M{x:.1f} {low:.1f}V{high:.1f}" stroke="#0072b2" stroke-width="2"/>')
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="#0072b2"/>')
        if 0.03 < mean < 0.97:
            parts.append(f'<text x="{x + 9:.1f}" y="{y + 5:.1f}" fill="#444">{edges:,} edges</text>')
    middle, centre = margin + size / 2, margin / 2 + size / 2
    parts.append(f'<text x="{middle}" y="{width - margin / 2:.0f}" text-anchor="middle">reported probability of being slack [%]</text>')
    parts.append(f'<text transform="rotate(-90 18 {centre})" x="18" y="{centre}" text-anchor="middle">edges that are slack [%]</text>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def main():
    surveys = int(sys.argv[1]) if len(sys.argv) > 1 else SURVEYS
    print("# Does the identification converge?\n")
    print("Written by `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/convergence.py`: random surveys of soft and stiff nets, whose")
    print("truth is known, identified by `taut identify --method map`. Lengths are uniform to 2 or 5 mm, the survey's standard")
    print("deviation is 0.05 to 2 mm, a tenth of the nodes is hidden or none, and 5 % of the targets have gross errors of 10 to 50")
    print("standard deviations or none. Lengths and tensions are *inside* where the truth is in their 95 % intervals; *reported* is the")
    print("part of the surveys with tensions. *Missed* are slack edges reported as determined or weakly determined. Times are of the")
    print("processor. Counts are of the surveys that converged.\n")
    print(*heading("net | surveys | converged | median [s] | largest [s] | lengths inside [%] | tensions reported [%] | inside [%] | "
                   "RMS error of the mean tension [%] | called slack | of them taut | missed"), sep="\n", flush=True)
    every, failures = [], []
    for name, *kind in NETS:
        with temporary_folder() as folder:
            net = Net(*kind, folder)
            outcomes = [outcome_of(net, number) for number in range(surveys)]
        print(row(name, outcomes), flush=True)
        every += outcomes
        failures += [f"- {name}, survey {one['number']}: {one['message']}" for one in outcomes if not one["converged"]]
    bins = reliability(every)
    print("\n## Slack probabilities\n", *heading("reported probability | edges | mean [%] | edges that are slack [%]"), sep="\n")
    for name, edges, mean, part in bins:
        print(f"| {name} | {edges} | {100 * mean:.1f} | {100 * part:.3g} |")
    print("\n## Surveys that did not converge\n")
    print("\n".join(failures) or "None.")
    if len(sys.argv) > 2:
        pathlib.Path(sys.argv[2]).write_text(diagram(bins))


if __name__ == "__main__":
    main()
