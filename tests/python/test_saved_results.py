# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a saved result that its own readers cannot take.

Report, export, plan and Python take whatever result.schema.json allows, or refuse it in one line
that names file and place.
"""

import copy
import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import hypothesis
import jsonschema
import pytest
import taut
from hypothesis import strategies as st
from hypothesis_jsonschema import from_schema

ROOT = Path(__file__).parents[2]
FULL = ROOT / "tests/data/results"
BUILT = ROOT / "build/release/result.schema.json"
SCHEMA = json.loads(Path(os.environ.get("TAUT_RESULT_SCHEMA", BUILT)).read_text())
KINDS = ("identification", "plan", "study", "comparison", "control")


def run(folder, *words):
    program = shutil.which("taut", path=Path(sys.executable).parent)
    command = [program, *map(str, words)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def must_run(folder, *words):
    done = run(folder, *words)
    assert done.returncode == 0, (words, done.stderr)


def read(path):
    return json.loads(path.read_text())


def write(path, document):
    path.write_text(json.dumps(document))


def export_all(folder):
    for to in ("net", "compas", "obj", "csv", "vtk"):
        must_run(folder, "export", "result.json", "--to", to, "-o", f"out.{to}")


# Every key.


def named(rule, name):
    """A rule, by the name of its definition where it has one."""
    while "$ref" in rule:
        name = rule["$ref"].split("/")[-1]
        rule = SCHEMA["definitions"][name]
    return rule, name


def alternatives(rule, name):
    """What a rule lets a value be, but for null: names and types, with the rule of each."""
    rule, name = named(rule, name)
    for number, alternative in enumerate(rule.get("anyOf", [])):
        yield from alternatives(alternative, f"{name}|{number}")
    types = rule.get("type", [])
    for kind in [types] if isinstance(types, str) else types:
        if kind != "null":
            yield name, kind, rule


def all_parts(rule, place, seen):
    for name, kind, own in alternatives(rule, place):
        seen |= {place, f"{name}:{kind}"}
        for key, below in own.get("properties", {}).items() if kind == "object" else ():
            all_parts(below, f"{name}/{key}", seen)
        if kind == "object" and "additionalProperties" in own:
            all_parts(own["additionalProperties"], f"{name}/*", seen)
        if kind == "array":
            all_parts(own["items"], f"{name}[]", seen)
    return seen


IS_OF = {
    "object": lambda value: isinstance(value, dict),
    "array": lambda value: isinstance(value, list),
    "string": lambda value: isinstance(value, str),
    "boolean": lambda value: isinstance(value, bool),
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "number": lambda value: isinstance(value, (int, float)) and not isinstance(value, bool),
}


def filled_parts(value, rule, place, seen, unknown):
    for name, kind, own in alternatives(rule, place):
        if not IS_OF[kind](value):
            continue
        seen |= {place, f"{name}:{kind}"}
        if kind == "object":
            properties = own.get("properties", {})
            for key, member in value.items():
                below = properties.get(key, own.get("additionalProperties"))
                if below is None:
                    unknown.add(f"{name}/{key}")
                else:
                    at = f"{name}/{key if key in properties else '*'}"
                    filled_parts(member, below, at, seen, unknown)
        if kind == "array":
            for entry in value:
                filled_parts(entry, own["items"], f"{name}[]", seen, unknown)


def test_full_results_have_every_key_of_the_schema_and_no_other():
    expected, seen, unknown = set(), set(), set()
    for kind in KINDS:
        document = read(FULL / f"full_{kind}.json")
        jsonschema.Draft7Validator(SCHEMA).validate(document)
        rule = {"$ref": f"#/definitions/{kind}"}
        all_parts(rule, kind, expected)
        filled_parts(document, rule, kind, seen, unknown)
    missing = sorted(expected - seen)
    assert not missing, f"{missing} in tests/data/results/make_full_results.py"
    # A net has keys of its own.
    others = sorted(key for key in unknown if not key.startswith("net_file/"))
    assert not others, f"{others} in the schema"


@pytest.mark.parametrize("kind", KINDS)
def test_a_full_result_goes_through_everything(kind, tmp_path):
    shutil.copy(FULL / f"full_{kind}.json", tmp_path / "result.json")
    must_run(tmp_path, "report", "result.json", "-o", "report.html")
    taut.write_report(tmp_path / "result.json", tmp_path / "python.html")
    assert (tmp_path / "python.html").read_text() == (tmp_path / "report.html").read_text()
    if kind == "identification":
        write(tmp_path / "net.json", read(tmp_path / "result.json")["cable_net"])
        must_run(tmp_path, "plan", "net.json", "result.json", "-o", "plan.json", "--accept-failed")
        export_all(tmp_path)


# Anything that the schema allows.

RESULT = read(FULL / "full_identification.json")
NET = RESULT["cable_net"]


def bounded(rule):
    """With indices that may be of the net, numbers that may be lengths, and short lists."""
    if isinstance(rule, list):
        return [bounded(below) for below in rule]
    if not isinstance(rule, dict):
        return rule
    rule = {key: bounded(below) for key, below in rule.items()}
    if rule.get("type") == "integer" and "maximum" in rule:
        rule["maximum"] = len(NET["nodes"]) - 1
    if rule.get("type") == "number" and "maximum" not in rule:
        rule = {"minimum": -0.01, **rule, "maximum": 0.01}
    if rule.get("type") == "array":
        rule = {"minItems": 1, "maxItems": 3, **rule}
    return rule


def parts_of_result():
    """Keys of an identification and of the objects in it, with what the schema lets them hold."""
    properties = SCHEMA["definitions"]["identification"]["properties"]
    for key in sorted(properties.keys() - {"format", "version", "net", "cable_net"}):
        rules = {}
        for _, kind, own in alternatives(properties[key], key):
            inner = own["properties"] if kind == "object" else {}
            rules |= {(key, name): rule for name, rule in inner.items()} or {
                (key,): properties[key]
            }
        for path, rule in rules.items():
            # from_schema() changes what it is given.
            yield path, bounded({**rule, "definitions": SCHEMA["definitions"]})


def with_own_names(value):
    """Ids and ends that are those of the edges and nodes that are named."""
    if isinstance(value, list):
        return [with_own_names(entry) for entry in value]
    if not isinstance(value, dict):
        return value
    value = {key: with_own_names(member) for key, member in value.items()}
    for kind in ("node", "edge"):
        if isinstance(value.get(kind), int) and "id" in value:
            value["id"] = NET[f"{kind}_ids"][value[kind]]
    if isinstance(value.get("edge"), int) and "nodes" in value:
        value["nodes"] = NET["edges"][value["edge"]]
    return value


COMMANDS = {
    "report": ["report", "result.json", "-o", "out"],
    "export": ["export", "result.json", "--to", "net", "-o", "out"],
    "plan": ["plan", "net.json", "result.json", "-o", "out", "--accept-failed"],
}


@pytest.mark.parametrize("part", list(parts_of_result()), ids=lambda part: "-".join(part[0]))
def test_what_the_schema_allows_is_taken_or_refused_in_one_line(part, tmp_path):
    path, rule = part
    write(tmp_path / "net.json", NET)
    output = tmp_path / "out"

    @hypothesis.settings(
        max_examples=4,
        deadline=None,
        derandomize=True,
        database=None,
        suppress_health_check=list(hypothesis.HealthCheck),
    )
    @hypothesis.given(from_schema(rule), st.sampled_from(sorted(COMMANDS)))
    def go_through(value, command):
        document = copy.deepcopy(RESULT)
        parent = document if len(path) == 1 else document[path[0]]
        parent[path[-1]] = with_own_names(value)
        write(tmp_path / "result.json", document)
        output.unlink(missing_ok=True)
        done = run(tmp_path, *COMMANDS[command])
        if done.returncode == 0 or (command == "plan" and done.returncode == 1):
            return  # 1: a plan without equilibrium or within no limits
        assert done.returncode == 2, done.stderr
        assert not output.exists()
        refusal = done.stderr.splitlines()[-1]
        assert re.match(r"taut: error: result\.json:(/| is )", refusal), done.stderr
        assert "exception" not in refusal
        with pytest.raises(taut.InputError, match=r"result\.json"):
            taut.write_report(tmp_path / "result.json", output)

    go_through()


# What identify finds.

NOISE = ("--noise", "0.5mm", "--prior", "uniform:3mm")
EXACT = ("--uncertain", "none")  # what the finding shows is not explained by anything else
UNCERTAIN = ("stiffness:5%", "stiffness-each:3%", "supports:1mm", "adjustable:0.5mm", "loads:20N")


@dataclasses.dataclass
class Case:
    """What is wrong with the net as built or its survey, and how a result shows that."""

    is_found: Callable  # in a result
    net: Callable = lambda net: None  # changes the net that is built
    survey: tuple = ()  # options of taut survey
    noise: str = "0.5mm"
    rows: Callable = lambda rows, net: rows  # of survey.csv, its header included
    words: tuple = NOISE  # options of taut identify
    force: Callable | None = None  # factor of the force measured in each of twenty edges
    second: Callable | None = None  # changes the net before a second survey


def interior(net):
    return [e for e in range(len(net["edges"])) if e not in net["adjustable"]]


def longer(edges_of, by):
    def change(net):
        for edge in edges_of(net):
            net["unstressed_lengths"][edge] += by

    return change


def with_a_support_lifted(net):
    net["nodes"][net["supports"][5]][2] += 0.012


def without_stds(rows, _net):
    return [row[:4] for row in rows]


def of_free_nodes(rows, net):
    return [row[:4] for row in rows if row[0] not in map(str, net["supports"])]


def swapped(rows, _net):
    rows[40][0], rows[41][0] = rows[41][0], rows[40][0]
    return rows


def boundary(kind):
    return lambda result: any(kind in one for one in result["diagnostics"]["boundary"])


CASES = {
    "adjustable edge": Case(
        boundary("edge"), net=longer(lambda net: net["adjustable"][2:3], -0.012)
    ),
    "support": Case(
        boundary("node"), net=with_a_support_lifted, survey=("--drop", "10%"),
        rows=of_free_nodes, words=(*NOISE, *EXACT),
    ),
    "length": Case(
        lambda result: result["diagnostics"]["length_outliers"],
        net=longer(lambda net: interior(net)[40:41], 0.03),
    ),
    "swapped names": Case(
        lambda result: any(
            "swapped_with" in one
            for one in result["survey"]["outliers"] + result["survey"]["unmatched"]
        ),
        rows=swapped,
    ),
    "noise": Case(
        lambda result: result["diagnostics"]["noise"]["ratio"] > 2, noise="2mm", rows=without_stds
    ),
    "frame": Case(lambda result: result["frame_offset"], survey=("--frame", "random")),
    "force": Case(
        lambda result: len(result["forces"]["outliers"]) == 1,
        force=lambda place: 1.5 if place == 0 else 1.0,
    ),
    "unit of forces": Case(
        lambda result: result["forces"]["bias"], words=(*NOISE, *EXACT), force=lambda place: 1.3
    ),
    "epoch": Case(
        lambda result: result["epochs"][1]["changes"],
        second=longer(lambda net: interior(net)[30:31], 0.01),
    ),
    "slack": Case(
        lambda result: any(edge["status"] == "slack" for edge in result["edges"]),
        net=longer(lambda net: interior(net)[30:31], 0.03),
        words=("--noise", "0.5mm", "--prior", "normal:15mm", "--prior-exact", *EXACT),
    ),
    "uncertain": Case(
        lambda result: result["uncertain"], survey=("--drop", "20%"),
        words=(*NOISE, *(word for name in UNCERTAIN for word in ("--uncertain", name))),
    ),
}  # fmt: skip


def make_survey(folder, change, case, seed, name):
    net = read(folder / "net.json")
    change(net)
    write(folder / "changed.json", net)
    built = ["--prior", "uniform:2mm", "--seed", 2, "-o", "built.csv"]
    must_run(folder, "form", "changed.json", *built)
    words = ["--noise", case.noise, "--seed", seed, "-o", name, *case.survey]
    must_run(folder, "survey", "changed.json", "built.csv", *words)


def words_of(case, folder):
    """Makes what identify reads, and gives its words."""
    must_run(folder, "example", "hypar:8x8", "-o", "net.json")
    make_survey(folder, case.net, case, 4, "survey.csv")
    net = read(folder / "net.json")
    rows = [row.split(",") for row in (folder / "survey.csv").read_text().splitlines()]
    rows = case.rows(rows, net)
    (folder / "survey.csv").write_text("".join(",".join(row) + "\n" for row in rows))
    words = ["identify", "net.json", "survey.csv", *case.words, "--quiet"]
    if case.second:
        make_survey(folder, case.second, case, 9, "second.csv")
        words += ["--epoch", "second.csv"]
    if case.force:
        must_run(folder, *words, "-o", "first.json")
        tension = read(folder / "first.json")["tension"]
        edges = enumerate(interior(net)[5:25])
        lines = [f"{edge},{case.force(place) * tension[edge]}\n" for place, edge in edges]
        (folder / "forces.csv").write_text("edge,tension\n" + "".join(lines))
        words += ["--forces", "forces.csv"]
    return words


@pytest.mark.parametrize("name", CASES)
def test_what_identify_finds_is_planned_on_shown_and_exported(name, tmp_path):
    words = words_of(CASES[name], tmp_path)
    done = run(tmp_path, *words, "--draws", "30", "-o", "result.json")
    assert done.returncode in (0, 1), done.stderr  # 1: it failed its checks, and is written
    result = read(tmp_path / "result.json")
    jsonschema.Draft7Validator(SCHEMA).validate(result)
    assert CASES[name].is_found(result)
    taut.write_report(tmp_path / "result.json", tmp_path / "report.html")
    export_all(tmp_path)
    words = ["plan", "net.json", "result.json", "-o", "plan.json", "--quiet"]
    if result["trust"]["verdict"] == "failed":
        assert run(tmp_path, *words).returncode == 2
        assert not (tmp_path / "plan.json").exists()
        words.append("--accept-failed")
    # 1: an edge that may be slack breaks the limit of every plan, which is written all the same.
    done = run(tmp_path, *words)
    edges = [*result["edges"], *result["adjustable_edges"]]
    may_be_slack = any((one["slack_probability"] or 0) > 0.05 for one in edges)
    is_kept = read(tmp_path / "plan.json")["feasible"]
    assert is_kept or may_be_slack, done.stderr
    assert done.returncode == (0 if is_kept else 1), done.stderr
    assert name != "slack" or not is_kept
    must_run(tmp_path, "report", "plan.json", "-o", "plan.html")
