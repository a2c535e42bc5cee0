# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against lengths that are not the program's, and a sure answer to a false survey."""

import json
import subprocess
import threading
import time

import numpy as np
import pytest
import taut


def test_lengths_are_found_with_their_intervals(net, found, deviations):
    assert found.status == "converged"
    assert found.trust == "passed", found.findings
    inside = (found.lower <= deviations) & (deviations <= found.upper)
    assert inside.mean() > 0.85
    assert np.sqrt(np.mean((found.length_deviation - deviations) ** 2)) < 1e-3
    assert found.edge.tolist() == net.interior_edges.tolist()
    assert found.length_draws.shape == (100, len(net.interior_edges))
    assert found.tension.shape == (len(net.edges),)
    assert np.all(found.tension_lower <= found.tension_upper)
    assert "passed" in repr(found)


def test_the_program_gives_the_same_to_the_last_bit(net, columns, tmp_path):
    net.save(tmp_path / "net.json")
    path = tmp_path / "survey.csv"
    names = list(columns)
    lines = [",".join(names).replace("id", "node")]
    lines += [
        ",".join(repr(float(v)) if not isinstance(v, str) else v for v in row)
        for row in zip(*columns.values(), strict=True)
    ]
    path.write_text("\n".join(lines) + "\n")
    result = tmp_path / "result.json"
    command = ["taut", "identify", tmp_path / "net.json", path, "-o", result, "--draws", "50"]
    subprocess.run(command, check=True, capture_output=True)
    loaded = taut.CableNet.load(tmp_path / "net.json")
    same = taut.identify(loaded, taut.read_survey(loaded, path), draws=50)
    theirs = json.loads(result.read_text())
    ours = same.to_dict()
    assert ours["edges"] == theirs["edges"]
    assert ours["trust"] == theirs["trust"]


def test_a_target_that_is_off_is_left_out_and_named(net, positions):
    with pytest.raises(ValueError, match="from its nominal place"):
        taut.read_survey(net, positions + 50.0, ids=net.free_nodes, noise=1e-3)
    moved = positions.copy()
    moved[7, 2] += 0.03
    result = taut.identify(
        net, taut.read_survey(net, moved, ids=net.free_nodes, noise=0.5e-3), draws=0
    )
    [finding] = [finding for finding in result.findings if finding["kind"] == "target"]
    assert finding["ids"] == [str(net.free_nodes[7])]
    assert finding["value"] == pytest.approx(0.03, abs=5e-3)
    assert finding["severity"] == "passed"
    assert finding["remedy"] is None
    saved = json.loads(result.to_json())["findings"]
    assert [one["reason"] for one in saved] == [one["reason"] for one in result.findings]


def test_a_clamp_that_slipped_is_in_the_diagnostics():
    saddle = taut.hypar(9, 9)
    longer, shorter = saddle.runs[4][4:6]
    data = saddle.to_dict()
    data["unstressed_lengths"][longer] += 0.01
    data["unstressed_lengths"][shorter] -= 0.01
    form = taut.solve_equilibrium(taut.CableNet.from_json(json.dumps(data))).form
    survey = taut.read_survey(saddle, taut.simulate_survey(saddle, form, noise=0.5e-3))
    found = taut.identify(saddle, survey, prior="uniform:2mm", draws=0)
    named = {(one["edge"], one["other"]) for one in found.diagnostics["length_outliers"]}
    assert named == {(longer, str(shorter)), (shorter, str(longer))}
    assert found.trust == "doubtful"


def test_what_is_not_given_is_assumed(net, survey):
    site = taut.identify(net, survey, prior="uniform:3mm", draws=50)
    assert [one["value"] for one in site.assumptions] == [
        "stiffness:5%",
        "stiffness-each:2%",
        "adjustable:0.5mm",
        "supports:1mm",
    ]
    assert {one["source"] for one in site.assumptions} == {"default"}
    exact = taut.identify(net, survey, prior="uniform:3mm", draws=50, uncertain=["none"])
    assert exact.assumptions == []
    assert np.mean(site.tension_upper - site.tension_lower) > np.mean(
        exact.tension_upper - exact.tension_lower
    )
    given = taut.identify(net, survey, prior="uniform:3mm", draws=0, uncertain=["stiffness:10%"])
    assert given.assumptions[0]["source"] == "given"
    assert not given.assumptions[0]["testable"]
    with pytest.raises(ValueError, match="cannot stand together"):
        taut.identify(net, survey, uncertain=["none"], uncertain=[])


def test_covariances_between_lengths(net, survey):
    pair = net.interior_edges[:2]
    found = taut.identify(net, survey, prior="uniform:3mm", draws=0, covariance_of=pair)
    assert found.length_covariance.shape == (2, 2)
    assert np.sqrt(np.diag(found.length_covariance)) == pytest.approx(found.std[:2], rel=1e-6)
    assert found.length_draws is None


def test_forces_read_are_taken(net, built, form, survey):
    edge = int(net.interior_edges[5])
    tension = float(taut.tensions(net, built.unstressed_lengths, form)[edge])
    found = taut.identify(net, survey, draws=0, readings=[(edge, tension, 0.01 * tension)])
    assert found.tension[edge] == pytest.approx(tension, rel=0.05)
    with pytest.raises(ValueError, match="edge"):
        taut.identify(net, survey, readings=[(10**6, 1.0, 1.0)])


def test_tables_and_files(net, found, tmp_path):
    pytest.importorskip("pandas")
    table = found.to_dataframe()
    assert len(table) == len(net.edges)
    assert np.isnan(table.length_deviation[net.adjustable_edges]).all()
    assert (table.status[net.adjustable_edges] == "adjustable").all()
    found.save(tmp_path / "result.json")
    assert json.loads((tmp_path / "result.json").read_text()) == found.to_dict()
    assert (tmp_path / "result_draws.h5").exists()


def test_a_model_is_trained_saved_and_used(net, survey, tmp_path):
    data = taut.Sampler(net, "uniform:3mm").draw(150)
    model = taut.train(net, data)
    model.save(tmp_path / "model.h5", net)
    loaded, of_net = taut.LengthModel.load(tmp_path / "model.h5")
    assert of_net == net
    first = taut.identify(net, survey, model=model)
    second = taut.identify(net, survey, model=loaded)
    assert first.method == "gp"
    assert np.array_equal(first.length_deviation, second.length_deviation)
    other = taut.hypar(4, 4)
    of_other = taut.read_survey(other, other.nodes, ids=range(len(other.nodes)), noise=1e-3)
    with pytest.raises(ValueError, match="trained for the net"):
        taut.identify(other, of_other, model=model)


def test_the_prospect_of_a_survey(net):
    all_targets = taut.inspect(net, noise=0.5e-3)
    some = taut.inspect(net, targets=net.free_nodes[::2], noise=0.5e-3)
    assert np.all(some.std >= all_targets.std - 1e-12)
    turned_round = taut.inspect(net, targets=net.free_nodes[::2][::-1], noise=0.5e-3)
    assert np.array_equal(turned_round.std, some.std)
    told = some.to_dict()
    assert [one["edge"] for one in told["edges"]] == net.interior_edges.tolist()
    assert told["edges"][3]["status"] == some.edge_status[3]
    free, support = int(net.free_nodes[0]), int(net.supports[0])
    for targets, why in [([10**6], "is none"), ([support], "is a support"), ([free] * 2, "twice")]:
        with pytest.raises(ValueError, match=f"targets: node .* {why}"):
            taut.inspect(net, targets=targets)
    with pytest.raises(ValueError, match="noise: got -1 m"):
        taut.inspect(net, noise=-1.0)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"method": "luck"}, "luck"),
        ({"prior": "uniform:5"}, "uniform:5"),
        ({"uncertain": ["weather:1"]}, "weather"),
        ({"draws": -1}, "draws"),
        ({"covariance_of": [10**6]}, "covariance"),
        ({"slack": [0], "taut": [0]}, "slack"),
    ],
)
def test_what_does_not_go_together_is_refused(net, survey, settings, words):
    with pytest.raises(ValueError, match=words):
        taut.identify(net, survey, **settings)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"prior": 5}, r"identify: prior: got int 5, expected str \| None"),
        ({"draws": 1.5}, "draws: got float, expected int"),
        ({"seed": -1}, "seed: got int -1"),
        ({"forces": [(1, 2)]}, r"forces: got list, expected Sequence\[tuple\["),
        ({"model": 1}, "model: got int 1, expected LengthModel"),
        ({"lawn": "uniform:5mm"}, "lawn: is no argument, expected prior"),
        ({"progress": 3}, "progress: got int, expected a function"),
    ],
)
def test_an_argument_of_a_wrong_type_is_told_by_its_name(net, survey, settings, words):
    with pytest.raises(TypeError, match=words):
        taut.identify(net, survey, **settings)


def test_arguments_that_are_missing_or_too_many_are_told(net, survey):
    with pytest.raises(TypeError, match="survey: is missing, expected Survey"):
        taut.identify(net)
    with pytest.raises(TypeError, match="survey: got ndarray, expected Survey"):
        taut.identify(net, survey.form)
    with pytest.raises(
        TypeError, match="got 3 arguments without a name, expected at most net, surv"
    ):
        taut.identify(net, survey, "map")


def test_the_interpreter_runs_on_while_taut_works(net, survey):
    counted = 0
    done = threading.Event()

    def work():
        for _ in range(5):
            taut.identify(net, survey, draws=50)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        counted += 1
        time.sleep(0.001)
    thread.join()
    assert counted > 5


def test_progress_is_told_and_its_exceptions_come_back(net):
    told = []
    data = taut.Sampler(net).draw(50, progress=lambda *what: told.append(what))
    assert len(data) == 50
    assert told
    stage, done, total = told[-1]
    assert isinstance(stage, str)
    assert 0 <= done <= total

    def fails(*_):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        taut.Sampler(net).draw(50, progress=fails)
