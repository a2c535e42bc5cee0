# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a survey on the wrong nodes, or of another standard deviation than was given."""

import itertools

import numpy as np
import pytest
import taut


def rows(columns):
    """The columns as taut's own CSV."""
    lines = [",".join(columns).replace("id", "node")]
    lines += [",".join(map(str, row)) for row in zip(*columns.values(), strict=True)]
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
    entries = of_mapping.to_dict()
    assert np.array_equal(entries["form"], of_mapping.form)
    assert entries["placed"][0]["name"] == columns["id"][0]
    assert entries["frame"] is None
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


def test_the_motion_of_a_survey_maps_rows(net, form):
    columns = taut.simulate_survey(net, form, noise=1e-4, random_frame=True, seed=5)
    survey = taut.read_survey(net, columns)
    motion = survey.to_dict()["frame"]["motion"]
    places = np.column_stack([columns[axis] for axis in "xyz"])
    moved = (places - motion["from"]) @ motion["rotation"].T + motion["to"]
    nodes = np.array([int(name) for name in columns["id"]])
    free = np.isin(nodes, net.free_nodes)
    assert moved[free] == pytest.approx(survey.form[nodes[free]], abs=1e-9)


def test_noise_of_each_point(net, positions):
    noise = np.full_like(positions, 1e-3)
    noise[:, 2] = 2e-3
    survey = taut.read_survey(net, positions, ids=net.free_nodes, noise=noise)
    assert np.array_equal(survey.noise_std[net.free_nodes], noise)
    in_mm = {"unit": "mm", "noise": (1e-3, 1e-3, 2e-3)}  # noise stays in metres
    same = taut.read_survey(net, 1e3 * positions[1:], ids=net.free_nodes[1:], **in_mm)
    assert same.missing.tolist() == [net.free_nodes[0]]
    assert np.array_equal(same.noise_std[same.surveyed], noise[1:])
    assert same.form[same.surveyed] == pytest.approx(positions[1:])


three = np.zeros((3, 3))
two = np.zeros((2, 3))
table = dict(zip("xyz", three, strict=True))
masked = np.ma.masked_array(three[0], mask=True)


@pytest.mark.parametrize(
    ("source", "settings", "error", "words"),
    [
        (np.zeros((3, 2)), {}, ValueError, r"source: got shape \(3, 2\)"),
        ({"x": [1.0], "y": [1.0]}, {}, ValueError, "expected x, y and z"),
        (table | {"sx": [1.0] * 3}, {}, ValueError, "sx, sy, sz"),
        (table | {"x": [1.0]}, {}, ValueError, r"shapes x \(1,\), y \(3,\)"),
        (table | {"x": ["1"]}, {}, TypeError, "x: got dtype str"),
        (table | {"x": masked}, {}, ValueError, "x: has masked entries"),
        (np.ma.masked_array(two, mask=[[0, 0, 1]] * 2), {}, ValueError, "source.*masked"),
        # Far more names than could be walked through.
        (table | {"id": range(10**15)}, {}, ValueError, "ids: got more than 3 names"),
        (three, {"ids": range(10**15)}, ValueError, "ids: got more than 3 names"),
        (three, {"ids": itertools.count()}, ValueError, "ids: got more than 3 names"),
        (three, {"ids": ["1"]}, ValueError, "ids: got 1 names, expected 3"),
        (three, {"ids": ["a", "b", "c"]}, ValueError, "0 of 3 targets"),
        (three, {"ids": 3}, TypeError, "ids: got int"),
        (three, {"ids": "abc"}, TypeError, "ids: got str"),
        (three, {"noise": [[1, 1, 1], [1, 0, 1], [1, 1, 1]]}, ValueError, "points:2: gives no"),
        (three, {"noise": "1kN"}, ValueError, "noise: '1kN'"),
        (two, {"noise": np.nan}, ValueError, "nan"),
        (two, {"frame": "mine"}, ValueError, "frame: got 'mine'"),
        (two, {"unit": "ell"}, ValueError, "unit: got 'ell'"),
        (two, {"match": "luck"}, ValueError, "match: got 'luck'"),
        (two, {"decimal": "comma"}, ValueError, "decimal: is for a file, and source holds points"),
        (two, {"unit": 2e-3}, ValueError, "unit: got 0.002, expected the metres of one of mm"),
        (two, {"unit": True}, TypeError, "unit: got bool, expected text or a number"),
        (two, {"offset": (1e-3,)}, ValueError, "offset: got 1 numbers, expected offset and"),
        (two, {"offset": np.nan}, ValueError, "offset: got nan, expected a finite number"),
        (two, {"control_points": "absent.csv"}, ValueError, "absent.csv"),
        (7, {}, ValueError, r"source: got shape \(\)"),
        (None, {}, TypeError, "source: got None"),
        ("absent.csv", {}, ValueError, "absent.csv"),
        ("absent.csv", {"ids": ["1"]}, ValueError, "ids"),
        ("absent.csv", {"file_format": "luck"}, ValueError, "no format 'luck'"),
        ("absent.csv", {"distance": "far"}, ValueError, "'far' is no precision of distances"),
        ("absent.csv", {"encoding": "ebcdic"}, ValueError, "encoding: got 'ebcdic', expected"),
    ],
)  # fmt: skip
def test_what_cannot_be_a_survey_is_refused_by_name(net, source, settings, error, words):
    with pytest.raises(error, match=words):
        taut.read_survey(net, source, **settings)


def test_old_names_of_arguments_are_taken_with_a_warning(net):
    with (
        pytest.warns(DeprecationWarning, match="read_survey: format is now file_format") as warned,
        pytest.raises(ValueError, match="no format 'luck'"),
    ):
        taut.read_survey(net, "absent.csv", format="luck")
    assert warned[0].filename == __file__


def test_what_is_no_net_is_refused_by_name(positions):
    with pytest.raises(TypeError, match="net: got str, expected CableNet"):
        taut.read_survey("net.json", positions)


def test_a_table_of_another_net_is_refused(survey):
    pytest.importorskip("pandas")
    with pytest.raises(ValueError, match="net: has 12 nodes, expected the survey's net of 45"):
        survey.to_dataframe(taut.hypar(2, 2))


def test_settings_of_a_file(net, columns, tmp_path):
    path = tmp_path / "points.txt"
    lines = [
        ";".join([str(name), *(str(1e3 * value).replace(".", ",") for value in place)])
        for name, *place in zip(columns["id"], *(columns[k] for k in "yxz"), strict=True)
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-16")
    settings = {"unit": "mm", "separator": "semicolon", "decimal": "comma", "encoding": "utf-16"}
    survey = taut.read_survey(
        net, path, columns="id,y,x,z", file_format="table", noise=1e-3, **settings
    )
    expected = taut.read_survey(net, columns, noise=None)
    assert survey.form == pytest.approx(expected.form, abs=1e-9)
    by_number = taut.read_survey(
        net, path, columns="id,y,x,z", file_format="table", noise=1e-3, **settings | {"unit": 1e-3}
    )
    assert (by_number.form == survey.form).all()


def test_offsets_of_targets(net, positions, tmp_path):
    table = tmp_path / "offsets.csv"
    table.write_text(f"target,offset\n{net.free_nodes[0]},5mm\n")
    of_points = {"ids": net.free_nodes, "noise": 1e-3}
    bare = taut.read_survey(net, positions, **of_points)
    for offset, first, others in [
        ({"offset": "3mm:0.2mm"}, 3e-3, 3e-3),
        ({"offset": (3e-3, 0.2e-3)}, 3e-3, 3e-3),
        ({"offset": np.float64(3e-3)}, 3e-3, 3e-3),
        ({"offsets": table}, 5e-3, 0),
    ]:
        off = taut.read_survey(net, positions, **of_points, **offset)
        moved = np.linalg.norm((off.form - bare.form)[net.free_nodes], axis=1)
        assert moved[0] == pytest.approx(first, rel=1e-6)
        assert moved[1:] == pytest.approx(others, rel=1e-6)


def test_messages_name_arguments_not_options_of_the_program(net, columns):
    with pytest.raises(ValueError, match="unit") as error:
        taut.read_survey(net, {k: v if k == "id" else 1e3 * v for k, v in columns.items()})
    assert "--" not in str(error.value)
    survey = taut.read_survey(net, {k: columns[k] for k in ("id", "x", "y", "z")}, noise=1e-4)
    with pytest.raises(ValueError, match="for the method map") as error:
        taut.identify(net, survey, method="gp", uncertain=["stiffness:5%"], taut_edges=[0])
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


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1e-3])
def test_standard_deviations_of_an_array_are_numbers(net, positions, wrong):
    stds = np.full(np.shape(positions), 5e-4)
    stds[:, 0] = wrong
    with pytest.raises(ValueError, match=r"standard deviations: got .* for point 1, expected"):
        taut.read_survey(net, positions, noise=stds)


def test_noise_of_each_axis_may_be_text(net, positions):
    by_text = taut.read_survey(net, positions, noise=["0.5mm", "0.5mm", 8e-4])
    by_number = taut.read_survey(net, positions, noise=[5e-4, 5e-4, 8e-4])
    assert np.array_equal(by_text.noise_std, by_number.noise_std)
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(np.full(np.shape(positions), 5e-4), columns=["sx", "sy", "sz"])
    assert np.all(taut.read_survey(net, positions, noise=table).noise_std[net.free_nodes] == 5e-4)
