# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a survey on the wrong nodes, or of other noise than was told."""

import itertools

import numpy as np
import pytest
import taut


def rows(columns):
    """The columns as taut's own CSV."""
    names = list(columns)
    lines = [",".join(names).replace("id", "node")]
    for row in zip(*columns.values(), strict=True):
        lines.append(",".join(str(one) for one in row))
    return "\n".join(lines) + "\n"


def test_a_mapping_a_frame_and_a_file_are_one_survey(net, columns, tmp_path):
    pandas = pytest.importorskip("pandas")
    of_mapping = taut.read_survey(net, columns)
    of_frame = taut.read_survey(net, pandas.DataFrame(columns))
    path = tmp_path / "survey.csv"
    path.write_text(rows(columns))
    of_file = taut.read_survey(net, path)
    for survey in (of_frame, of_file):
        assert np.array_equal(survey.form, of_mapping.form)
        assert np.array_equal(survey.noise_std, of_mapping.noise_std)
        assert survey.surveyed.tolist() == net.free_nodes.tolist()
    told = of_mapping.to_dict()
    assert np.array_equal(told["form"], of_mapping.form)
    assert told["placed"][0]["name"] == columns["id"][0]
    assert told["frame"] is None
    table = of_mapping.to_dataframe(net)
    assert table.x.to_numpy() == pytest.approx(of_mapping.form[of_mapping.surveyed, 0])


def test_an_array_is_put_on_nodes_by_names_or_by_place(net, positions):
    names = [net.node_id(int(k)) for k in net.free_nodes]
    by_name = taut.read_survey(net, positions, ids=names, noise=1e-3)
    by_number = taut.read_survey(net, positions, ids=net.free_nodes, noise=1e-3)
    by_place = taut.read_survey(net, positions[::-1], noise=1e-3)
    assert np.array_equal(by_name.form, by_place.form)
    assert np.array_equal(by_name.form, by_number.form)
    assert np.all(by_name.noise_std[net.free_nodes] == 1e-3)
    assert "noise 1 mm" in repr(by_name)


def test_the_motion_of_a_survey_is_told(net, form):
    columns = taut.simulate_survey(net, form, noise=1e-4, random_frame=True, seed=5)
    survey = taut.read_survey(net, columns)
    motion = survey.to_dict()["frame"]["motion"]
    places = np.column_stack([columns[axis] for axis in "xyz"])
    moved = (places - motion["from"]) @ motion["rotation"].T + motion["to"]
    nodes = np.array([int(name) for name in columns["id"]])
    free = np.isin(nodes, net.free_nodes)
    assert moved[free] == pytest.approx(survey.form[nodes[free]], abs=1e-9)


def test_what_was_not_measured_is_missing(net, positions):
    survey = taut.read_survey(net, positions[1:], noise=1e-3)
    assert survey.missing.tolist() == [net.free_nodes[0]]


def test_noise_of_each_point(net, positions):
    noise = np.full_like(positions, 1e-3)
    noise[:, 2] = 2e-3
    survey = taut.read_survey(net, positions, ids=net.free_nodes, noise=noise)
    assert np.array_equal(survey.noise_std[net.free_nodes], noise)
    same = taut.read_survey(net, positions, ids=net.free_nodes, noise=(1e-3, 1e-3, 2e-3))
    assert np.array_equal(same.noise_std, survey.noise_std)


def test_millimetres_are_told(net, positions):
    survey = taut.read_survey(net, positions * 1e3, ids=net.free_nodes, noise=1e-3, unit="mm")
    assert survey.form[net.free_nodes] == pytest.approx(positions)


@pytest.mark.parametrize(
    ("source", "settings", "error", "words"),
    [
        (np.zeros((3, 2)), {}, ValueError, r"source: got shape \(3, 2\)"),
        ({"x": [1.0], "y": [1.0]}, {}, ValueError, "expected x, y and z"),
        ({"x": [1.0], "y": [1.0], "z": [1.0], "sx": [1.0]}, {}, ValueError, "sx, sy, sz"),
        (np.zeros((3, 3)), {"ids": ["1"]}, ValueError, "ids: got 1 names, expected 3"),
        # Far more than could be walked through.
        (np.zeros((3, 3)), {"ids": range(10**15)}, ValueError, "ids: got more than 3 names"),
        (np.zeros((3, 3)), {"ids": itertools.count()}, ValueError, "ids: got more than 3 names"),
        (
            {"x": np.zeros(3), "y": np.zeros(3), "z": np.zeros(3), "id": range(10**15)},
            {},
            ValueError,
            "ids: got more than 3 names",
        ),
        (np.zeros((3, 3)), {"ids": ["a", "b", "c"]}, ValueError, "0 of 3 targets"),
        (
            np.zeros((3, 3)),
            {"noise": np.array([[1e-3] * 3, [1e-3, 0, 1e-3], [1e-3] * 3])},
            ValueError,
            "points:2: gives no standard deviations above 0",
        ),
        (np.zeros((0, 3)), {}, ValueError, "none"),
        (np.full((2, 3), np.nan), {}, ValueError, "not finite"),
        (np.zeros((2, 3)), {"noise": -1.0}, ValueError, "-1"),
        (np.zeros((2, 3)), {"noise": np.nan}, ValueError, "nan"),
        (np.zeros((2, 3)), {"frame": "mine"}, ValueError, "frame: got 'mine'"),
        (np.zeros((2, 3)), {"unit": "ell"}, ValueError, "unit: got 'ell'"),
        (np.zeros((2, 3)), {"match": "luck"}, ValueError, "match: got 'luck'"),
        (7, {}, ValueError, r"source: got shape \(\)"),
        (None, {}, TypeError, "source: got None"),
        (
            np.ma.masked_array(np.ones((2, 3)), mask=[[0, 0, 1]] * 2),
            {},
            ValueError,
            "source.*masked",
        ),
        ({"x": [1.0, 2.0], "y": [1.0], "z": [1.0]}, {}, ValueError, r"shapes x \(2,\), y \(1,\)"),
        ({"x": ["1"], "y": [1.0], "z": [1.0]}, {}, TypeError, "x: got dtype str"),
        (
            {"x": np.ma.masked_array([1.0], mask=[True]), "y": [1.0], "z": [1.0]},
            {},
            ValueError,
            "x: has masked entries",
        ),
        (np.zeros((3, 3)), {"ids": 3}, TypeError, "ids: got int"),
        (np.zeros((3, 3)), {"ids": "abc"}, TypeError, "ids: got str"),
        (np.zeros((3, 3)), {"noise": "1mm"}, TypeError, "noise: got '1mm', expected a number"),
        ("absent.csv", {}, ValueError, "absent.csv"),
        ("absent.csv", {"ids": ["1"]}, ValueError, "ids"),
    ],
)
def test_what_cannot_be_a_survey_is_refused_by_name(net, source, settings, error, words):
    with pytest.raises(error, match=words):
        taut.read_survey(net, source, **settings)


def test_what_is_no_net_is_refused_by_name(positions):
    with pytest.raises(TypeError, match="net: got str, expected CableNet"):
        taut.read_survey("net.json", positions)


def test_a_table_of_another_net_is_refused(survey):
    pytest.importorskip("pandas")
    with pytest.raises(ValueError, match="net: has 12 nodes, expected the survey's net of 45"):
        survey.to_dataframe(taut.hypar(2, 2))


def test_what_is_told_of_a_file(net, columns, tmp_path):
    path = tmp_path / "points.txt"
    lines = [
        ";".join([str(name), *(str(1e3 * value).replace(".", ",") for value in place)])
        for name, *place in zip(columns["id"], *(columns[k] for k in "yxz"), strict=True)
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-16")
    told = {"unit": "mm", "separator": "semicolon", "decimal": "comma", "encoding": "utf-16"}
    survey = taut.read_survey(net, path, columns="id,y,x,z", format="table", noise=1e-3, **told)
    expected = taut.read_survey(net, columns, noise=None)
    assert survey.form == pytest.approx(expected.form, abs=1e-9)
    with pytest.raises(ValueError, match="encoding: got 'ebcdic', expected 'utf-8'"):
        taut.read_survey(net, path, encoding="ebcdic")
    with pytest.raises(ValueError, match="separator: got 'dash', expected 'comma', 'semicolon'"):
        taut.read_survey(net, path, separator="dash")
    with pytest.raises(ValueError, match="decimal: is for a file, and source holds points"):
        taut.read_survey(net, columns, decimal="comma")
    with pytest.raises(TypeError, match="unit: got float, expected text"):
        taut.read_survey(net, path, unit=1e-3)


def test_targets_stand_off_the_cables(net, positions, tmp_path):
    bare = taut.read_survey(net, positions, ids=net.free_nodes, noise=1e-3)
    off = taut.read_survey(net, positions, ids=net.free_nodes, noise=1e-3, offset="3mm:0.2mm")
    moved = np.linalg.norm((off.form - bare.form)[net.free_nodes], axis=1)
    assert moved == pytest.approx(3e-3, rel=1e-6)
    table = tmp_path / "offsets.csv"
    table.write_text(f"target,offset\n{net.free_nodes[0]},5mm\n")
    one = taut.read_survey(net, positions, ids=net.free_nodes, noise=1e-3, offsets=table)
    moved = np.linalg.norm((one.form - bare.form)[net.free_nodes], axis=1)
    assert moved[0] == pytest.approx(5e-3)
    assert np.all(moved[1:] == 0)


def test_messages_name_arguments_not_options_of_the_program(net, columns):
    with pytest.raises(ValueError, match="unit") as error:
        taut.read_survey(net, {k: v if k == "id" else 1e3 * v for k, v in columns.items()})
    assert "--" not in str(error.value)
    survey = taut.read_survey(net, {k: columns[k] for k in ("id", "x", "y", "z")}, noise=1e-4)
    with pytest.raises(ValueError, match="for method='map'") as error:
        taut.identify(net, survey, method="gp", uncertain=["stiffness:5%"], taut=[0])
    assert "--" not in str(error.value)
    found = taut.identify(net, survey, prior="uniform:5mm", prior_exact=True, uncertain=["none"])
    assert found.findings
    assert all("--" not in f["next"] + f["reason"] for f in found.findings)
    assert any(
        "prior='" in f["next"] and f["remedy"]["parameter"] == "prior" for f in found.findings
    )
    [noise] = [f for f in found.findings if f["kind"] == "survey_noise"]
    assert f"noise={noise['remedy']['value']:.6g}" in noise["next"]
    again = taut.read_survey(
        net, {k: columns[k] for k in ("id", "x", "y", "z")}, noise=noise["remedy"]["value"]
    )
    assert again.noise_std.max() == pytest.approx(noise["value"] * 1e-4, rel=1e-2)
