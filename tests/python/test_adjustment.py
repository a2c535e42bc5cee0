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
    assert "limits are kept" in repr(plan)
    assert plan.warnings == []
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


def test_whole_steps_crews_and_files(found, tmp_path):
    plan = taut.plan(found, stroke=0.02, turn=2e-3, step=0.25, crews=2, tension=(100.0, None))
    steps = plan.strokes / 0.5e-3
    assert np.abs(steps - np.round(steps)).max() < 1e-6
    plan.save(tmp_path / "plan.json", csv=tmp_path / "turns.csv")
    assert json.loads((tmp_path / "plan.json").read_text()) == plan.to_dict()
    assert (tmp_path / "turns.csv").read_text() == plan.to_csv()


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


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"stroke": -1.0}, "stroke"),
        ({"target": np.zeros((2, 3))}, "target"),
        ({"edges": [10**6]}, "edge"),
        ({"edges": []}, "edges: got none"),
        ({"step": 0.25}, "step"),
        ({"crews": 0}, "crew"),
        ({"thread": "up"}, "thread"),
        ({"suggest_adjustable": -1}, "suggest_adjustable: got -1"),
    ],
)
def test_what_cannot_be_planned_is_refused(found, settings, words):
    with pytest.raises(ValueError, match=words):
        taut.plan(found, **settings)
