# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against studies that are not those of the program."""

import json
import subprocess

import pytest
import taut


def test_the_papers_experiment_is_that_of_the_program(net, tmp_path):
    net.save(tmp_path / "net.json")
    command = ["taut", "reproduce", "--net", "net.json", "--samples", "40", "--validation", "5"]
    subprocess.run([*command, "-o", "out"], cwd=tmp_path, check=True, capture_output=True)
    theirs = json.loads((tmp_path / "out" / "results.json").read_text())
    loaded = taut.CableNet.load(tmp_path / "net.json")
    ours = taut.reproduce(loaded, samples=40, validation=5)
    assert ours["errors"] == theirs["errors"]
    assert ours["methods"]["gp"]["mse"] == theirs["methods"]["gp"]["mse"]


def test_simulated_jobs_are_those_of_the_program(net, tmp_path):
    net.save(tmp_path / "net.json")
    command = [
        "taut",
        "control",
        "net.json",
        "--tension",
        "0.1kN..40kN",
        "--turn",
        "5mm",
        "--step",
        "1/4",
    ]
    few = {"draws": 20, "rounds": 1, "trials": 2}
    given = [text for name, value in few.items() for text in (f"--{name}", str(value))]
    subprocess.run([*command, *given, "-o", "out"], cwd=tmp_path, check=True, capture_output=True)
    theirs = json.loads((tmp_path / "out" / "control.json").read_text())
    loaded = taut.CableNet.load(tmp_path / "net.json")
    ours = taut.control(loaded, tension=(100.0, 40e3), turn=5e-3, step=0.25, **few)
    assert ours["settings"] == theirs["settings"]
    assert ours["strategies"] == theirs["strategies"]
    with pytest.raises(ValueError, match="step"):
        taut.control(loaded, step=0.25)


def test_methods_beside_each_other(net):
    sizes = {"training_samples": [50], "hidden_parts": [], "surveys": 3}
    made = taut.compare(net, noises=[5e-4], seed=2, **sizes)
    methods = {row["method"] for row in made["rows"]}
    assert {"gp", "map"} <= methods
    with pytest.raises(ValueError, match="surveys"):
        taut.compare(net, surveys=0)
