# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against turns that do not lead to the form that was planned."""

import json
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import taut


def test_a_plan_leads_where_it_says(found):
    plan = taut.plan(found, stroke=0.02)
    assert plan.is_feasible
    assert "limits are kept" in repr(plan)
    assert [one.split(":")[0] for one in plan.warnings] == ["THE TURNS GAIN LITTLE"]
    lengths = np.array(found.built.unstressed_lengths)
    lengths[plan.edges] += plan.strokes
    form = taut.solve_equilibrium(found.built, lengths).form
    assert np.abs(form - plan.form).max() < 1e-6


def test_every_field_of_cpp_is_shown(found):
    plan = taut.plan(found, turn=2e-3, step=0.25, suggest_adjustable=2, suggest_targets=0.5e-3)
    saved = plan.to_dict()
    assert plan.planned == saved["form"]["planned"]
    assert plan.unconstrained == saved["form"]["unconstrained"]
    assert plan.normal_std == saved["form"]["normal_std"] > 0.0
    assert np.allclose(plan.form_std, saved["planned_form_std"], atol=1e-9)
    assert plan.form_std.shape == plan.form.shape
    variances = np.diagonal(plan.form_covariance, axis1=1, axis2=2)
    assert np.allclose(np.sqrt(variances), plan.form_std, atol=1e-15)
    covariances = np.array(saved["planned_form_covariance"])
    assert np.allclose(covariances[:, [0, 3, 5]], variances, rtol=1e-5, atol=1e-15)
    assert np.all(plan.tension_lower <= plan.tension_upper)
    [limits] = plan.effective_limits
    assert limits["lower"].shape == plan.tension.shape
    assert (plan.draws, plan.no_draws_because, plan.breaches) == (100, "", [])
    assert plan.is_within_tolerance is None
    assert plan.order["safe_probability"] == plan.safe_probability
    for key in ("edge", "stroke", "pass", "crew", "step"):
        assert [one[key] for one in plan.order["turnings"]] == [one[key] for one in saved["turns"]]
    assert plan.order["worst"]["step"] == -1
    suggested = saved["suggested_adjustable"]
    assert [one["edge"] for one in plan.suggested_adjustable] == [one["edge"] for one in suggested]
    suggested = saved["suggested_targets"]["targets"]
    assert [one["node"] for one in plan.suggested_targets] == [one["node"] for one in suggested]
    assert taut.plan(found).suggested_adjustable is None
    assert plan.turns == saved["turns"]
    assert plan.options == saved["options"]
    assert plan.largest_stroke == saved["largest_stroke"] == np.abs(plan.strokes).max()


def test_files(found, tmp_path):
    plan = taut.plan(found, stroke=0.02, turn=2e-3, step=0.25, crews=2, tension=(100.0, None))
    plan.save(tmp_path / "plan.json", csv=tmp_path / "turns.csv")
    assert json.loads((tmp_path / "plan.json").read_text()) == plan.to_dict()
    assert (tmp_path / "turns.csv").read_text() == plan.to_csv()


def test_quantities_may_be_text_with_a_unit(found):
    numbers = taut.plan(
        found, stroke=0.012, tension=(1000.0, None), turn=0.005, actuator_std=2e-4,
        reaction=30e3, total_stroke=0.03,
    )  # fmt: skip
    texts = taut.plan(
        found, stroke="12mm", tension=("1kN", None), turn="5mm", actuator_std="0.2 mm",
        reaction="30kN", total_stroke="3cm",
    )  # fmt: skip
    assert texts.to_json() == numbers.to_json()
    for settings, words in [
        ({"stroke": "12kN"}, "stroke: '12kN'"),
        ({"tension": ("1mm", None)}, "tension: '1mm'"),
        ({"turn": "fast"}, "turn: 'fast'"),
        ({"stroke": {0: ("-1mm", "1kN")}}, "stroke: '1kN'"),
    ]:
        with pytest.raises(ValueError, match=words):
            taut.plan(found, **settings)


def test_edges_come_in_any_order(found):
    edges = found.net.adjustable_edges
    assert np.array_equal(taut.plan(found, edges=edges[::-1]).strokes, taut.plan(found).strokes)


def test_a_plan_on_a_failed_identification_is_made_only_where_that_is_accepted(net, columns):
    # Half a millimetre of noise, taken for far less.
    sure = {**columns, **{axis: np.full(len(columns["x"]), 1.5e-4) for axis in ("sx", "sy", "sz")}}
    failed = taut.identify(net, taut.read_survey(net, sure), prior="uniform:3mm", draws=0)
    assert failed.trust == "failed"
    with pytest.raises(ValueError, match="accept_failed=True"):
        taut.plan(failed)
    plan = taut.plan(failed, accept_failed=True)
    assert plan.trust == "failed"
    assert "the identification is failed" in repr(plan)
    assert plan.warnings[0].startswith("DO NOT TURN BY THIS LIST: the identification failed")


def test_a_table_of_strokes(found):
    pytest.importorskip("pandas")
    plan = taut.plan(found)
    table = plan.to_dataframe()
    assert table.index.tolist() == plan.edges.tolist()
    assert table.stroke.to_numpy() == pytest.approx(plan.strokes)


@pytest.fixture(scope="module")
def job(net, columns, tmp_path_factory):
    """An identified net with groups and breaking loads, and the files of its plans."""
    folder = tmp_path_factory.mktemp("job")
    net.save(folder / "net.json")
    document = json.loads((folder / "net.json").read_text())
    at_edge = net.adjustable_edges[:4].tolist()
    document["groups"] = {"ridge": at_edge}
    document["breaking_load"] = [60e3] * len(net.edges)
    (folder / "net.json").write_text(json.dumps(document))
    grouped = taut.CableNet.load(folder / "net.json")
    wet = np.zeros_like(net.nodes)
    wet[net.free_nodes, 2] = -50.0
    for name, columns_of in (("wet.csv", wet), ("form.csv", net.nodes - 2e-5 * wet)):
        lines = [
            f"{net.node_id(node)},{x},{y},{z}" for node, (x, y, z) in enumerate(columns_of.tolist())
        ]
        (folder / name).write_text("\n".join(["id,x,y,z", *lines]) + "\n")
    low, high = net.nodes.min(axis=0), net.nodes.max(axis=0)
    count = 12
    u, v = np.meshgrid(*[np.linspace(-0.1, 1.1, count)] * 2, indexing="ij")
    places = np.stack([low[0] + u * (high[0] - low[0]), low[1] + v * (high[1] - low[1])], axis=-1)
    near = np.linalg.norm(places.reshape(-1, 1, 2) - net.nodes[None, :, :2], axis=2).argmin(axis=1)
    vertices = np.column_stack([places.reshape(-1, 2), net.nodes[near, 2]])
    corner = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    triangles = np.concatenate(
        [
            np.column_stack([corner, corner + 1, corner + count]),
            np.column_stack([corner + 1, corner + count + 1, corner + count]),
        ]
    )
    text = [f"v {x} {y} {z}" for x, y, z in (1e3 * vertices).tolist()]
    text += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles.tolist()]
    (folder / "roof.obj").write_text("\n".join(text) + "\n")
    weight = "\n".join(f"{net.node_id(node)},3,0.5" for node in net.free_nodes[:5])
    (folder / "weights.csv").write_text(f"id,normal,tangential\n{weight}\n")
    (folder / "forces.csv").write_text(f"edge,tension\n{net.edge_id(at_edge[1])},2500\n")
    strokes = "\n".join(f"{net.edge_id(edge)},-0.004,0.01" for edge in net.adjustable_edges[:9])
    (folder / "strokes.csv").write_text(f"edge,shortest,longest\n{strokes}\n")
    survey = taut.read_survey(grouped, columns)
    found = taut.identify(grouped, survey, prior="uniform:3mm", draws=60)
    found.save(folder / "result.json")
    weights = np.ones(len(net.nodes)), np.full(len(net.nodes), 0.1)
    weights[0][net.free_nodes[:5]] = 3.0
    weights[1][net.free_nodes[:5]] = 0.5
    return {
        "folder": folder,
        "found": found,
        "wet": wet,
        "surface": (vertices, triangles),
        "weights": weights,
        "forces": {at_edge[1]: 2.5e3},
    }


JOBS = {
    "strokes": (
        ["--stroke", "2mm", "--turn", "4mm", "--step", "1/16"],
        lambda job: {"stroke": 0.002, "turn": 0.004, "step": 0.0625},
    ),
    "strokes since the design": (
        ["--total-stroke", "2mm"],
        lambda job: {"total_stroke": 0.002},
    ),
    "strokes by edge": (
        ["--stroke", "strokes.csv"],
        lambda job: {
            "stroke": dict.fromkeys(job["found"].net.adjustable_edges[:9].tolist(), (-0.004, 0.01))
        },
    ),
    "tension by group": (
        ["--tension", "10N..", "--tension", "..40kN@ridge", "--confidence", "90%"],
        lambda job: {"tension": {"ridge": (None, 40e3), None: (10.0, None)}, "confidence": 0.9},
    ),
    "parts of breaking loads": (
        ["--tension", "..60%"],
        lambda job: {"tension_part": (None, 0.6)},
    ),
    "reactions and later loads": (
        [
            *("--reaction", "5kN", "--reaction", "4kN@ridge", "--check", "wet.csv"),
            *("--tension", "..7.1kN"),
        ],
        lambda job: {
            "reaction": {None: 5e3, "ridge": 4e3},
            "load_cases": {"wet.csv": job["wet"]},
            "tension": (None, 7.1e3),
        },
    ),
    "surface": (
        ["--target", "roof.obj", "--target-unit", "mm", "--objective", "largest"],
        lambda job: {
            "target": job["folder"] / "roof.obj",
            "target_unit": "mm",
            "objective": "largest",
        },
    ),
    "weights": (
        ["--target", "form.csv", "--node-weights", "weights.csv"],
        lambda job: {"target": str(job["folder"] / "form.csv"), "weights": job["weights"]},
    ),
    "target tensions": (
        [
            *("--target-tension", "3kN:10%@ridge", "--target-tension", "forces.csv"),
            *("--form-tolerance", "2mm"),
        ],
        lambda job: {
            "target_tension": {"ridge": (3e3, 300.0), **job["forces"]},
            "form_tolerance": 0.002,
        },
    ),
    "target tensions alone": (
        ["--target-tension", "2kN", "--weights", "normal:0,tangential:0", "--objective", "largest"],
        lambda job: {"target_tension": 2e3, "weights": (0.0, 0.0), "objective": "largest"},
    ),
    "stages": (
        ["--stages", "ridge:50%"],
        lambda job: {"stages": [("ridge", 0.5)]},
    ),
    "suggestions": (
        ["--suggest-adjustable", "2", "--suggest-targets", "0.5mm", "--crews", "2"],
        lambda job: {"suggest_adjustable": 2, "suggest_targets": 0.5e-3, "crews": 2},
    ),
}


@pytest.mark.parametrize("name", JOBS)
def test_each_setting_of_a_job_changes_its_plan(job, name):
    # So that the program and Python cannot agree in leaving one out.
    settings = {"stroke": 0.015, **JOBS[name][1](job)}
    plan = taut.plan(job["found"], **settings).to_dict()
    for left_out in JOBS[name][1](job):
        less = {key: value for key, value in settings.items() if key != left_out}
        try:
            assert taut.plan(job["found"], **less).to_dict() != plan, left_out
        except ValueError:
            continue  # what is given needs it


@pytest.mark.parametrize("name", JOBS)
def test_a_plan_is_that_of_the_program_to_the_last_digit(job, name):
    words, settings = JOBS[name]
    program = shutil.which("taut", path=Path(sys.executable).parent)
    command = [program, "plan", "net.json", "result.json", "-o", "plan.json", "--quiet", *words]
    done = subprocess.run(command, cwd=job["folder"], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr  # 1: it breaks limits, and is written
    of_program = json.loads((job["folder"] / "plan.json").read_text())
    plan = taut.plan(job["found"], **{"stroke": 0.015, **settings(job)})
    assert plan.is_feasible == (done.returncode == 0)
    assert plan.strokes.size > 0
    for key in ("date", "command"):
        del of_program[key]
    assert plan.to_dict() == of_program
    assert pickle.loads(pickle.dumps(plan)).to_json() == plan.to_json()


def test_target_tensions_are_forces_by_edge_or_an_array(found):
    edges = found.net.adjustable_edges[:2]
    tensions = np.full(len(found.net.edges), np.nan)
    tensions[edges] = 3e3
    plan = taut.plan(found, target_tension=tensions, form_tolerance=0.1)
    named = taut.plan(found, target_tension={int(e): 3e3 for e in edges}, form_tolerance=0.1)
    assert plan.to_json() == named.to_json()
    for reached in plan.target_tensions:
        assert reached["edge"] in edges
        assert (reached["target"], reached["tolerance"]) == (3e3, 150.0)
    for one, saved in zip(plan.target_tensions, plan.to_dict()["target_tensions"], strict=True):
        assert {**one, "edge_id": found.net.edge_id(one["edge"])} == saved


def test_a_step_is_a_part_of_a_turn(found):
    for step, words in [(0, "step: got 0, expected a part"), (-0.25, "step: is -0.25 of a turn")]:
        with pytest.raises(ValueError, match=words):
            taut.plan(found, turn=2e-3, step=step)


def test_a_target_tension_may_be_text(found):
    by_text = taut.plan(found, target_tension="250N")
    assert by_text.target_tensions == taut.plan(found, target_tension=250.0).target_tensions


def test_a_surface_may_be_an_array(job):
    vertices, triangles = job["surface"]
    named = taut.plan(job["found"], target=job["folder"] / "roof.obj", target_unit="mm")
    given = taut.plan(job["found"], target=(1e3 * vertices, triangles), target_unit="mm")
    assert given.to_json() == named.to_json()
    with pytest.warns(UserWarning, match="1 of 243 triangles have no area"):
        taut.plan(job["found"], target=(vertices, np.vstack([triangles, [0, 0, 1]])))


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"stroke": {}}, "stroke: names no edge"),
        ({"stroke": {10**6: (-1.0, 1.0)}}, "edge"),
        ({"tension": {"ridge": (1.0, None)}}, "tension: names the group 'ridge'"),
        ({"tension_part": (0.2, 0.6)}, "has no breaking_load"),
        ({"reaction": {"ridge": 1.0}}, "reaction: names the group 'ridge'"),
        ({"load_cases": {"wet": np.zeros((2, 3))}}, "load_cases: got shape"),
        ({"objective": "mean"}, "objective: got 'mean'"),
        ({"target_unit": "mm"}, "target_unit: is for a surface"),
        ({"target_unit": "yard"}, "target_unit: got 'yard'"),
        ({"target_tension": {"ridge": 1.0}}, "target_tension: names the group 'ridge'"),
        ({"target_tension": np.ones(2)}, "target_tension: got shape"),
        ({"target_tension": {}}, "target_tension: got none"),
        ({"form_tolerance": 1e-3}, "form_tolerance: weighs"),
        ({"target": (np.zeros((4, 3)), np.zeros((1, 4), int))}, "its triangles are not"),
        ({"target": np.zeros((2, 3))}, "target"),
        ({"edges": []}, "edges: got none"),
        ({"step": 0.25}, "step"),
        ({"thread": "up"}, "thread"),
        ({"suggest_adjustable": -1}, "suggest_adjustable: is -1"),
    ],
)
def test_what_cannot_be_planned_is_refused(found, settings, words):
    with pytest.raises(ValueError, match=words):
        taut.plan(found, **settings)


@pytest.mark.parametrize(
    "settings",
    [
        {"tension": 3.0},
        {"target_tension": {0: "x"}},
        {"reaction": "much"},
        {"load_cases": 1},
        {"stroke": {0: 1.0}},
    ],
)
def test_what_is_of_no_such_kind_is_refused_by_its_name(found, settings):
    [name] = settings
    with pytest.raises((TypeError, ValueError), match=name):
        taut.plan(found, **settings)


def test_without_samples_a_plan_promises_nothing(net, survey):
    plan = taut.plan(taut.identify(net, survey, draws=0), tension=(1.0, 1e6))
    assert plan.is_feasible
    assert (plan.safe_probability, plan.limit_probability) == (None, None)
    assert "not surely" in repr(plan)


def test_a_design_that_is_no_form_of_its_lengths_is_named(net, survey):
    lifted = np.array(net.nodes)
    lifted[net.free_nodes, 2] += 0.02
    odd = taut.CableNet.from_dict(net.to_dict() | {"nodes": lifted})
    plan = taut.plan(taut.identify(odd, survey, draws=0))
    assert any(one.startswith("THE TARGET IS NO FORM OF THIS NET") for one in plan.warnings)
    assert not any("NO FORM" in one for one in taut.plan(taut.identify(net, survey)).warnings)
