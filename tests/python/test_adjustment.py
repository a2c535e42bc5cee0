# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against turns that do not lead to the form that was planned."""

import json

import numpy as np
import pytest
import taut


def test_a_plan_leads_where_it_says(found):
    plan = taut.plan(found, stroke=0.02)
    assert plan.is_feasible
    assert plan.planned["normal_rmse"] < plan.as_built["normal_rmse"]
    lengths = np.array(found.built.unstressed_lengths)
    lengths[plan.edges] += plan.strokes
    form = taut.solve_equilibrium(found.built, lengths).form
    assert np.abs(form - plan.form).max() < 1e-6
    assert np.abs(plan.strokes).max() <= 0.02 + 1e-12
    assert "limits are kept" in repr(plan)


def test_whole_steps_limits_and_crews(found, tmp_path):
    plan = taut.plan(found, stroke=0.02, turn=2e-3, step=0.25, crews=2, tension=(100.0, None))
    steps = plan.strokes / 0.5e-3
    assert np.abs(steps - np.round(steps)).max() < 1e-6
    plan.save(tmp_path / "plan.json", csv=tmp_path / "turns.csv")
    assert json.loads((tmp_path / "plan.json").read_text()) == plan.to_dict()
    assert (tmp_path / "turns.csv").read_text() == plan.to_csv()
    assert len(plan.to_csv().splitlines()) > len(plan.edges)
    plan.save(tmp_path / "alone.json")
    assert (tmp_path / "alone.json").read_text() == (tmp_path / "plan.json").read_text()


def test_edges_come_in_any_order(found):
    edges = found.net.adjustable_edges
    assert np.array_equal(taut.plan(found, edges=edges[::-1]).strokes, taut.plan(found).strokes)


def test_a_plan_on_a_doubtful_identification_says_so(found, survey):
    assert taut.plan(found).trust == found.trust == "passed"
    assert taut.plan(found).warnings == []
    few = taut.identify(found.net, survey, prior="uniform:0.2mm", draws=0)
    assert few.trust != "passed"
    plan = taut.plan(few, accept_failed=True)
    assert f"the identification is {few.trust}" in repr(plan)


def test_a_plan_on_a_failed_identification_is_made_only_where_that_is_accepted(net, columns):
    # Half a millimetre of noise, taken for far less.
    sure = {**columns, **{axis: np.full(len(columns["x"]), 1.5e-4) for axis in ("sx", "sy", "sz")}}
    failed = taut.identify(net, taut.read_survey(net, sure), prior="uniform:3mm", draws=0)
    assert failed.trust == "failed"
    with pytest.raises(ValueError, match="accept_failed=True"):
        taut.plan(failed)
    plan = taut.plan(failed, accept_failed=True)
    assert plan.warnings[0].startswith("DO NOT TURN BY THIS LIST: the identification failed")
    assert plan.to_csv().startswith(f"# {plan.warnings[0]}")
    assert plan.to_dict()["warnings"] == plan.warnings


def test_a_plan_says_how_surely_its_steps_break_no_limit(found):
    plan = taut.plan(found)
    assert plan.is_safe
    assert 0.95 <= plan.safe_probability <= 1.0
    assert plan.to_dict()["order"]["safe_probability"] == plan.safe_probability


def test_a_table_of_strokes(found):
    pytest.importorskip("pandas")
    plan = taut.plan(found)
    table = plan.to_dataframe()
    assert table.index.tolist() == plan.edges.tolist()
    assert table.stroke.to_numpy() == pytest.approx(plan.strokes)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"stroke": -1.0}, "stroke"),
        ({"stroke": float("nan")}, "stroke"),
        ({"target": np.zeros((2, 3))}, "target"),
        ({"edges": [10**6]}, "edge"),
        ({"edges": []}, "edges: got none"),
        ({"step": 0.25}, "step"),
        ({"crews": 0}, "crew"),
        ({"thread": "up"}, "thread"),
        ({"confidence": 2.0}, "confidence"),
        ({"tolerance": -1.0}, "tolerance"),
    ],
)
def test_what_cannot_be_planned_is_refused(found, settings, words):
    with pytest.raises(ValueError, match=words):
        taut.plan(found, **settings)
