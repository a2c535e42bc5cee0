#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Makes the results beside this script, in which every key of their schema has a value.

The program writes them for a small net; values that do not occur there are filled in here. Add a new
key to one of the functions below, then run: make_full_results.py PROGRAM
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
PROGRAM = Path(sys.argv[1]).resolve()


def taut(folder, words):
    done = subprocess.run(
        [PROGRAM, *words.split()], cwd=folder, capture_output=True, text=True, check=False
    )
    if done.returncode not in (0, 1):  # 1: a plan that cannot keep its limits is written
        raise SystemExit(done.stderr)


def read(path):
    return json.loads(path.read_text())


def make_net(folder):
    taut(folder, "example hypar:3x4 -o net.json")
    net = read(folder / "net.json")
    net["loads"] = [[0.0, 0.0, -1.0]] * len(net["nodes"])
    net["node_ids"] = [f"N{i}" for i in range(len(net["nodes"]))]
    net["edge_ids"] = [f"E{e}" for e in range(len(net["edges"]))]
    net["groups"] = {"all": list(range(len(net["edges"])))}
    (folder / "net.json").write_text(json.dumps(net))
    return net


def interior(net):
    return [e for e in range(len(net["edges"])) if e not in net["adjustable"]]


def free(net):
    return [i for i in range(len(net["nodes"])) if i not in net["supports"]]


def identify(folder, net):
    """From one survey with all options, and from two."""
    taut(folder, "form net.json --prior uniform:3mm --seed 2 -o built.csv --lengths truth.csv")
    taut(folder, "survey net.json built.csv --noise 0.2mm --drop 10% -o one.csv")
    taut(folder, "survey net.json built.csv --noise 0.2mm --seed 5 -o two.csv")
    asked = [net["edge_ids"][e] for e in interior(net)[:2]]
    (folder / "asked.txt").write_text("\n".join(asked) + "\n")
    uncertain = "--uncertain stiffness:5%@all --uncertain stiffness-each:3% --uncertain supports:0.5mm"
    common = "--prior uniform:3mm --draws 20 --quiet"
    one = f"identify net.json one.csv {common}"
    taut(folder, f"{one} {uncertain} --covariance-of asked.txt -o one.json")
    taut(folder, f"{one} --epoch two.csv -o both.json")
    taut(folder, f"identify net.json two.csv {common} --frame supports -o moved.json")
    return (read(folder / f"{name}.json") for name in ("one", "both", "moved"))


def full_identification(folder, net):
    result, both, moved = identify(folder, net)
    inner, nodes = interior(net), free(net)
    edge = {"edge": inner[0], "id": net["edge_ids"][inner[0]]}
    turnbuckle = {"edge": net["adjustable"][1], "id": net["edge_ids"][net["adjustable"][1]]}
    support = {"node": net["supports"][0], "id": net["node_ids"][net["supports"][0]]}
    target = {"node": nodes[0], "id": net["node_ids"][nodes[0]]}
    turned = [{**turnbuckle, "stroke": 0.0005, "std": 0.0001}]
    outlier = {**target, "distance": 0.01, "statistic": 90.0, "swapped_with": net["node_ids"][nodes[1]]}
    boundary = [
        {**turnbuckle, "deviation": -0.0005, "std": 0.0002, "statistic": 40.0,
         "confounded_with": support["id"]},
        {**support, "deviation": [0.0, 0.0005, 0.0], "std": [2e-4, 2e-4, 2e-4], "statistic": 30.0,
         "confounded_with": None},
    ]
    offset = {
        "about": [0.0, 0.0, 0.0], "translation": [0.0002, 0.0, 0.0],
        "translation_std": [1e-4, 1e-4, 1e-4], "rotation": [0.0, 0.0, 0.0],
        "rotation_std": [1e-4, 1e-4, 1e-4],
    }
    trust = {"verdict": "failed", "reasons": ["one", "two", "three"]}
    findings = [
        {"kind": kind, "severity": severity, "ids": ["5"], "value": 0.0123, "std": 0.0004,
         "confounded_with": ["7"], "remedy": {"parameter": "prior", "value": "uniform:8mm"},
         "reason": reason, "next": "Look at it."}
        for kind, severity, reason in (
            ("prior", "failed", "one"), ("length", "doubtful", "two"), ("target", "passed", "three")
        )
    ]
    control = [{"id": "C1", "dx": 1e-4, "dy": 0.0, "dz": 0.0}]
    epochs = both["epochs"]
    for epoch in epochs:
        epoch.update(turned=turned, outliers=[outlier], boundary=boundary, frame_offset=offset,
                     trust=trust, findings=findings)
        epoch["load"] = 1500.0
        epoch["changes"] = [{**edge, "change": 0.002, "std": 0.0003, "statistic": 7.0}]
    result.update(date="2026-11-21 06:30 UTC", trust=trust, findings=findings, frame_offset=offset,
                  turned=turned, epochs=epochs, frame=moved["frame"])
    result["frame"] = result["frame"] or {
        "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "from": [0, 0, 0], "to": [0, 0, 0],
        "fit": {"rms": 1e-4, "count": 1}, "control": control,
    }
    result["prior"]["common"].update(struts=0.0002, struts_std=0.0003)
    result["detectable"].update(adjustable=0.004, support=0.009, temperature=12.0, force=0.4, force_scale=0.25, load=12.0)
    result["diagnostics"].update(boundary=boundary, boundary_not_released=1)
    result["diagnostics"]["prior"].update(found=True, contradicted="uniform:1mm", likeliest="uniform:3mm")
    result["diagnostics"]["length_outliers"] = [
        {**edge, "deviation": 0.004, "std": 0.001, "statistic": 5.0, "other": net["edge_ids"][inner[1]],
         "node": net["node_ids"][nodes[2]], "swapped": False, "beside_target": True}
    ]
    result["forces"] = {
        "measurements": 2,
        "outliers": [{
            **edge, "measured": 5000.0, "expected": 4000.0, "statistic": 20.0, "source": "frequency", "mode": 2,
            "probability": 0.5
        }],
        "bias": {"part": 0.2, "std": 0.01, "probability": 0.5},
        "contradicted_taut": [inner[1]],
        "contradicted_slack": [inner[2]],
    }
    result["draws"]["reason"] = "made up"
    result["edges"][1]["status"] = "not_determined"
    result["edges"][2]["status"] = "slack"
    survey = result["survey"]
    survey.update(outliers=[outlier], control=control, warnings=["made up"])
    survey["unmatched"] = [
        {"id": "T1", "line": 3, "reason": "far", "nearest": net["node_ids"][nodes[2]], "distance": 0.1,
         "swapped_with": net["node_ids"][nodes[3]]}
    ]
    # Places of the supports by all parts of the result.
    for i in net["supports"]:
        result["form"][i] = [
            x + t for x, t in zip(net["nodes"][i], offset["translation"], strict=True)
        ]
    result["stretches"] = [{
        "edges": inner[:2], "ids": [net["edge_ids"][e] for e in inner[:2]], "nominal": 2.0,
        "friction": 0.1, "length_deviation": 0.0012, "std": 0.0007, "tension": 30000.0, "tension_std": 150.0,
    }]
    for one in result["uncertain"]:
        if one["name"] == "supports":
            result["form"][one["node"]]["xyz".index(one["axis"])] += one["mean"]
    result["form"][support["node"]][1] += 0.0005
    return result


def full_plan(folder, net):
    (folder / "turnable.txt").write_text(
        "\n".join(net["edge_ids"][e] for e in net["adjustable"][:8]) + "\n"
    )
    taut(
        folder,
        "plan net.json one.json --tension 0.1kN..3kN --turn 5mm --step 1/4 --crews 2 --thread left"
        " --tolerance 1mm --suggest-adjustable 2 --suggest-targets 0.2mm --quiet"
        " --adjustable turnable.txt -o plan.json",
    )
    plan = read(folder / "plan.json")
    breaches = [
        {"kind": "tension", "edge": 0, "id": net["edge_ids"][0]},
        {"kind": "reaction", "node": net["supports"][0], "id": net["node_ids"][net["supports"][0]]},
    ]
    for breach in breaches:
        breach.update(load_case="snow.csv", value=5000.0, limit=4000.0, probability=0.1)
    plan["violations"] = breaches
    plan["order"].update(safe=False, worst={"step": 0, "breach": breaches[0]})
    plan["identification"] = {"verdict": "doubtful", "reasons": ["made up"]}
    plan["no_draws_because"] = "made up"
    plan["warnings"] = ["made up"]
    plan["limits_given"] = True
    plan["order"]["safe_probability"] = 0.5
    plan["order"]["stages"] = [
        {"name": "made up", "part": 0.5, "step": 0, "least_tension": 3000.0, "most_tension": 5000.0,
         "safe_probability": 0.75}
    ]
    for turn in plan["turns"]:
        turn["frequency_after_step"] = 17.5
    plan["tolerance"].update(reached=False, fewest_bound=2)
    for edge in plan["tension"]["edges"]:
        edge.update(lower=0.9 * edge["planned"], upper=1.1 * edge["planned"])
    node = free(net)[0]
    plan["suggested_targets"]["targets"] = [
        {"node": node, "id": net["node_ids"][node], "normal_std": 0.0002}
    ]
    plan["target_tensions"] = [
        {"edge": edge, "edge_id": net["edge_ids"][edge], "target": 3000.0, "tolerance": 150.0,
         "as_built": 4000.0, "planned": 3500.0, "unconstrained": 3400.0, "of_any_form": 3100.0,
         "mean": 3450.0, "std": 200.0, "probability": 0.1, "obstacle": obstacle}
        for edge, obstacle in enumerate(["none", "limits", "form", "turnbuckles"])
    ]
    plan["options"]["form_tolerance"] = 0.005
    for edge in plan["suggested_adjustable"]:
        edge["tension_rmse_after"] = 2.5
    plan["cable_net"]["axial_stiffness"] = [net["axial_stiffness"]] * len(net["edges"])
    plan["date"] = "2026-11-21 06:30 UTC"
    return plan


def full_study(folder):
    taut(folder, "reproduce --net net.json --prior uniform:3mm --samples 12 --validation 2 -o study --quiet")
    study = read(folder / "study/results.json")
    study["paper"] = {"mse": 1.7e-8, "mrse": 0.002, "form_error": study["form_error"]}
    for method in study["methods"].values():
        method["first_failure"] = "made up"
    return study


def full_comparison(folder):
    taut(
        folder,
        "compare net.json --prior uniform:3mm --noise 0,0.2mm --training 10 --surveys 2"
        " --uncertain supports:1mm --quiet -o comparison",
    )
    comparison = read(folder / "comparison/comparison.json")
    comparison["epoch_rows"] = [{**comparison["rows"][0], "epochs": 2, "turned": True}]
    for rows in ("rows", "model_error_rows", "epoch_rows"):
        for row in comparison[rows]:
            row["first_failure"] = "made up"
    return comparison


def full_control(folder):
    taut(
        folder,
        "control net.json --prior uniform:3mm --tension 0.05kN..20kN --draws 50 --rounds 1 --trials 1"
        " --noise 0.2mm -o control --quiet",
    )
    control = read(folder / "control/control.json")
    control["settings"]["step"] = 0.001
    return control


def lines(document):
    """One line per key, so that a change shows in a diff."""
    keys = [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in document.items()]
    return "{\n" + ",\n".join(keys) + "\n}\n"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        net = make_net(folder)
        documents = {
            "identification": full_identification(folder, net),
            "plan": full_plan(folder, net),
            "study": full_study(folder),
            "comparison": full_comparison(folder),
            "control": full_control(folder),
        }
    for kind, document in documents.items():
        document["command"] = "taut, and by hand"
        (HERE / f"full_{kind}.json").write_text(lines(document))


main()
