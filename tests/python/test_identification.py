# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against results that are not the program's, and arguments that are misunderstood."""

import copy
import json
import pickle
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import taut


def test_arrays_are_of_the_edges_that_they_name(net, found, deviations):
    assert found.status == "converged"
    assert found.trust == "passed", found.findings
    assert "passed" in repr(found)
    inside = (found.lower <= deviations) & (deviations <= found.upper)
    assert inside.mean() > 0.85
    assert found.edge.tolist() == net.interior_edges.tolist()
    assert found.length_draws.shape == (100, len(net.interior_edges))
    assert found.tension.shape == (len(net.edges),)
    assert np.all(found.tension_lower <= found.tension_upper)


def test_every_field_of_cpp_is_shown(net, form, survey, found):
    assert np.array_equal(found.predicted.form, found.form)
    off = (found.form - survey.form)[survey.surveyed]
    assert found.residuals == pytest.approx(np.linalg.norm(off, axis=1))
    assert {one["parameter"] for one in found.uncertain} == {
        "stiffness:5%", "stiffness-each:2%", "adjustable:0.5mm", "supports:1mm"
    }  # fmt: skip
    assert found.draws["forms"].shape == (100, 3 * len(net.free_nodes))
    assert np.array_equal(found.draws["length_deviations"], found.length_draws)
    assert found.drawn["tensions"][3]["tension"]["lower"] == found.tension_lower[3]
    assert found.contradicted_prior is None
    assert found.prior_was_given
    assert (found.outliers, found.force_measurements, found.epochs, found.turned) == ([], 0, [], [])
    moved = np.array(survey.form)
    moved[net.free_nodes[7], 2] += 0.03
    edge = int(net.interior_edges[10])
    second = taut.read_survey(net, taut.simulate_survey(net, form, noise=0.5e-3, seed=4))
    both = taut.identify(
        net,
        taut.read_survey(net, moved[net.free_nodes], ids=net.free_nodes, noise=0.5e-3),
        forces=[(edge, 1.8 * found.tension[edge], 0.01 * found.tension[edge])],
        epochs=[(second, [(0, 0.0, 1e-4)])],
        prior="uniform:3mm",
        draws=0,
    )
    first, last = both.epochs
    assert first["outliers"][0]["node"] == net.free_nodes[7]
    assert first["outliers"][0]["distance"] == pytest.approx(0.03, abs=5e-3)
    [finding] = [one for one in first["findings"] if one["kind"] == "target"]
    assert finding["ids"] == [net.node_id(int(net.free_nodes[7]))]
    assert last["turned"] == both.turned == [{"edge": 0, "stroke": 0.0, "std": 1e-4}]
    assert both.force_outliers[0]["edge"] == edge
    assert both.draws is None


def test_what_to_dict_holds_is_an_attribute(net, survey, found):
    equilibrium = taut.solve_equilibrium(net)
    for result in (survey, equilibrium):
        assert set(result.to_dict()) <= set(dir(result)), type(result)
    of_the_file = {
        "format",
        "version",
        "program",
        "net_fingerprint",
        "cable_net",
        "date",
        "command",
    }
    by_edge = {
        "edges",
        "adjustable_edges",
        "forces",
    }  # as arrays, and as force_measurements and more
    assert set(found.to_dict()) - of_the_file - by_edge <= set(dir(found))
    assert found.noise == pytest.approx(0.5e-3)
    assert found.frame is None
    assert found.missing_places == []
    assert found.mean_tension["lower"] < np.mean(found.tension) < found.mean_tension["upper"]
    assert survey.frame is None
    assert survey.unmatched == []
    assert survey.has_own_noise
    assert {one["node"] for one in survey.placed} > set(survey.surveyed)  # and the supports
    assert len(equilibrium.energy_decreases) == equilibrium.iterations


def test_tuples_take_quantities_as_text(net, form, survey):
    second = taut.read_survey(net, taut.simulate_survey(net, form, noise=0.5e-3, seed=4))
    tension = taut.identify(net, survey, draws=0).tension[3]
    settings = {"prior": "uniform:3mm", "draws": 0}
    by_number = taut.identify(
        net, survey, forces=[(3, tension, 50.0)], epochs=[(second, [(0, 1e-3, 2e-4)])], **settings
    )
    by_text = taut.identify(
        net,
        survey,
        forces=[(3, f"{float(tension)!r}N", "0.05kN")],
        epochs=[(second, [(0, "1mm", "0.2mm")])],
        **settings,
    )
    assert np.array_equal(by_text.length_deviation, by_number.length_deviation)
    with pytest.raises(ValueError, match="forces: '5 pounds'"):
        taut.identify(net, survey, forces=[(3, "5 pounds", 50.0)])


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


def test_what_is_not_given_is_assumed(net, survey, found):
    assert {one["source"] for one in found.assumptions} == {"default"}
    given = taut.identify(net, survey, draws=0, uncertain=["stiffness:10%"])
    assert given.assumptions[0] | {"source": "given", "testable": False} == given.assumptions[0]
    assert taut.identify(net, survey, draws=0, uncertain=["none"]).assumptions == []


def test_arguments_of_version_0_2_are_taken_with_a_warning(net, survey, found):
    force = (3, float(found.tension[3]), 50.0)
    with pytest.warns(DeprecationWarning, match="is now") as warned:
        old = taut.identify(
            net, survey, law="uniform:3mm", readings=[force], unknowns=["supports:1mm"], draws=0
        )
    assert [str(one.message) for one in warned] == [
        "identify: law is now prior",
        "identify: readings is now forces",
        "identify: unknowns is now uncertain=['none', ...]",
    ]
    assert {one.filename for one in warned} == {__file__}
    uncertain = ["none", "supports:1mm"]
    new = taut.identify(
        net, survey, prior="uniform:3mm", forces=[force], uncertain=uncertain, draws=0
    )
    assert new.to_json() == old.to_json()
    with pytest.warns(DeprecationWarning, match="Sampler: law is now prior"):
        assert taut.Sampler(net, law="uniform:2mm").draw(1).prior == "uniform:2mm"
    with pytest.warns(DeprecationWarning, match="plan: further is now suggest_adjustable"):
        assert len(taut.plan(found, further=1).suggested_adjustable) == 1
    with pytest.raises(TypeError, match="identify: law: is the old name of prior, which is given"):
        taut.identify(net, survey, law="uniform:3mm", prior="uniform:3mm")
    with pytest.warns(DeprecationWarning, match="identify: taut is now taut_edges"):
        taut.identify(net, survey, draws=0, taut=[0])
    with pytest.raises(TypeError, match="inspect: readings: is no argument"):
        taut.inspect(net, readings=[])


def test_covariances_between_lengths(net, survey):
    pair = net.interior_edges[:2]
    found = taut.identify(net, survey, prior="uniform:3mm", draws=0, covariance_of=pair)
    assert found.length_covariance.shape == (2, 2)
    assert np.sqrt(np.diag(found.length_covariance)) == pytest.approx(found.std[:2], rel=1e-6)
    assert found.length_draws is None


def test_covariances_of_places(net, found):
    of_nodes = np.array(found.form_covariance)
    assert of_nodes.shape == (len(net.nodes), 3, 3)
    rows, columns = np.triu_indices(3)
    saved = np.array(found.to_dict()["form_covariance"])
    assert np.allclose(of_nodes[:, rows, columns], saved, rtol=1e-5, atol=1e-14)
    assert np.all(np.linalg.eigvalsh(of_nodes)[net.free_nodes] > 0.0)
    assert copy.deepcopy(found).form_covariance[0].tolist() == of_nodes[0].tolist()


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
    model = taut.train(net, taut.Sampler(net, "uniform:3mm").draw(150))
    model.save(tmp_path / "model.h5", net)
    loaded, of_net = taut.LengthModel.load(tmp_path / "model.h5")
    assert of_net == net
    first = taut.identify(net, survey, model=model)
    assert first.method == "gp"
    second = taut.identify(net, survey, model=loaded)
    assert np.array_equal(first.length_deviation, second.length_deviation)


def test_a_survey_is_predicted(net):
    some = taut.inspect(net, targets=net.free_nodes[::2], noise=0.5e-3)
    assert np.all(some.std >= taut.inspect(net, noise=0.5e-3).std - 1e-12)
    turned_round = taut.inspect(net, targets=net.free_nodes[::2][::-1], noise=0.5e-3)
    assert np.array_equal(turned_round.std, some.std)
    entries = some.to_dict()
    assert [one["edge"] for one in entries["edges"]] == net.interior_edges.tolist()
    assert entries["edges"][3]["status"] == some.edge_status[3]
    assert some.force_candidates[0]["mean_std_if_measured"] < some.mean_tension_std
    free, support = int(net.free_nodes[0]), int(net.supports[0])
    for targets, why in [([10**6], "is none"), ([support], "is a support"), ([free] * 2, "twice")]:
        with pytest.raises(ValueError, match=f"targets: node .* {why}"):
            taut.inspect(net, targets=targets)
    with pytest.raises(ValueError, match="noise: got -1 m"):
        taut.inspect(net, noise=-1.0)


def test_measurements_are_suggested_by_their_worth(net):
    found = taut.suggest_measurements(net, noise=0.5e-3, count=3)
    assert [step["total_cost"] for step in found.steps] == [1.0, 2.0, 3.0]
    assert found.left_out[0].startswith("frequencies and sags: the net has no mass")
    assert found.to_dict()["steps"] == found.steps
    assert pickle.loads(pickle.dumps(found)).to_dict() == found.to_dict()
    dear = taut.suggest_measurements(net, costs={"load": 100, "load-cell": 1e5}, count=1, load=50.0)
    assert [(step["kind"], step["expected"]) for step in dear.steps] == [("load", 50.0)]
    some = net.free_nodes[::2]
    form = taut.suggest_measurements(net, targets=some, quantity="form", costs={"target": 0.01})
    assert form.steps[0]["kind"] == "target"
    assert form.steps[0]["node"] not in some


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"method": "luck"}, "luck"),
        ({"draws": -1}, "draws"),
        ({"covariance_of": [10**6]}, "covariance"),
        ({"slack_edges": [0], "taut_edges": [0]}, "slack"),
    ],
)
def test_arguments_that_contradict_each_other_are_refused(net, survey, settings, words):
    with pytest.raises(ValueError, match=words):
        taut.identify(net, survey, **settings)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"prior": 5}, r"identify: prior: got int 5, expected str \| None"),
        ({"draws": 1.5}, "draws: got float, expected int"),
        ({"seed": -1}, "seed: got int -1"),
        ({"forces": [(1, 2)]}, r"forces: got list \[.1, 2.\], expected Sequence\[tuple\["),
        (
            {"draws": 50, "uncertain": {}},
            r"identify: uncertain: got dict {}, expected Sequence\[str\]$",
        ),
        ({"draws": 50, "forces": [(1, None, 3)]}, r"forces: got NoneType, expected a force in N"),
        (
            {"draws": 50, "uncertain": ["none"], "seed": -1},
            "identify: seed: got int -1, .*int, of 0",
        ),
        ({"model": 1}, "model: got int 1, expected LengthModel"),
        ({"priors": "uniform:5mm"}, "priors: is no argument, expected prior"),
        ({"progress": 3}, "progress: got int, expected a function"),
    ],
)
def test_an_argument_of_a_wrong_type_is_named(net, survey, settings, words):
    with pytest.raises(TypeError, match=words):
        taut.identify(net, survey, **settings)


def test_arguments_that_are_missing_or_too_many_are_named(net, survey):
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


def test_progress_is_reported_and_its_exceptions_come_back(net):
    calls = []
    data = taut.Sampler(net).draw(50, progress=lambda *what: calls.append(what))
    assert len(data) == 50
    stage, done, total = calls[-1]
    assert isinstance(stage, str)
    assert 0 <= done <= total

    def fails(*_):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        taut.Sampler(net).draw(50, progress=fails)


def test_two_samples_are_unsure_and_their_file_is_read(net, survey, tmp_path):
    found = taut.identify(net, survey, draws=2)
    assert found.mean_tension["lower"] >= 0.0
    widest = found.mean_tension["upper"] - found.mean_tension["lower"]
    assert widest > 10.0 * found.mean_tension["std"]
    found.save(tmp_path / "result.json")
    net.save(tmp_path / "net.json")
    subprocess.run(
        [
            shutil.which("taut", path=Path(sys.executable).parent),
            "plan",
            "net.json",
            "result.json",
            "--confidence",
            "50%",
            "-o",
            "plan.json",
        ],
        cwd=tmp_path,
        check=True,
    )
    with pytest.raises(ValueError, match="draws is 1, expected 0, or 2 to"):
        taut.identify(net, survey, draws=1)
