# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against figures of other numbers than the result's."""

import json

import numpy as np
import pytest
import taut

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure
from taut import plot


@pytest.fixture(scope="module")
def study(net):
    return taut.reproduce(net, samples=40, validation=5)


def line(figure, label):
    (found,) = [one for one in figure.axes[0].get_lines() if one.get_label() == label]
    return found.get_ydata()


def test_the_papers_figures(study):
    figures = plot.figures(study)
    assert set(figures) == {
        "net_plan",
        "length_deviations",
        "length_errors",
        "form_error_nominal",
        "form_error_identified",
    }
    sample = study["sample"]
    error = np.array(sample["identified"]) - np.array(sample["true"])
    assert line(figures["length_deviations"], "error") == pytest.approx(1e3 * error)
    scales = [figures[f"form_error_{k}"].axes[1].get_xlim() for k in ("nominal", "identified")]
    assert scales[0] == scales[1], "both forms are on one colour scale"


def test_figures_of_an_identification_and_a_plan(found):
    figures = plot.figures(found)
    assert {"length_intervals", "tension_intervals", "residual_map"} <= set(figures)
    shown = line(figures["length_intervals"], "estimate")
    assert shown == pytest.approx(np.sort(1e3 * found.length_deviation))
    figures = plot.figures(taut.plan(found).to_dict())
    assert {"plan_normal_built", "plan_strokes", "plan_tensions"} <= set(figures)


def test_figures_of_a_form_a_survey_and_a_predicted_precision(net, columns):
    (heights,) = plot.figures(taut.solve_equilibrium(net)).values()
    shown = np.array(heights.axes[0].collections[0].get_array())
    assert shown == pytest.approx(net.nodes[:, 2], abs=1e-6)
    some = taut.read_survey(net, {name: values[10:] for name, values in columns.items()})
    (nodes,) = plot.figures(some).values()
    assert line(nodes, "not surveyed") == pytest.approx(net.nodes[some.missing, 1])
    assert len(line(nodes, "surveyed")) + len(some.missing) == len(net.free_nodes)
    assert len(line(nodes, "support")) == len(net.supports)
    precision = taut.inspect(net)
    (stds,) = plot.figures(precision).values()
    assert line(stds, "after the survey") == pytest.approx(1e3 * np.sort(precision.std))


def test_a_figure_in_axes_of_ones_own(found):
    axes = Figure().subplots(1, 2)
    assert plot.draw(found, "length_intervals", ax=axes[0]) is axes[0]
    shown = next(one for one in axes[0].get_lines() if one.get_label() == "estimate").get_ydata()
    assert shown == pytest.approx(np.sort(1e3 * found.length_deviation))
    assert plot.draw(found.net, "net_plan", ax=axes[1]).get_xlabel() == "x [m]"
    with pytest.raises(ValueError, match="name: got 'strokes', expected one of net_plan, length_"):
        plot.draw(found, "strokes", ax=axes[0])
    suggested = taut.suggest_measurements(found.net, count=1)
    for wrong in (found.net.nodes, taut.CableNet, suggested, {"format": []}):
        with pytest.raises(
            ValueError, match=r"^result: got .*, which has no figures, expected Cab"
        ):
            plot.figures(wrong)
    with pytest.raises(TypeError, match="ax: got ndarray, expected"):
        plot.draw(found, "net_plan", ax=axes)
    with pytest.raises(ValueError, match="ax: has the projection '3d'"):
        plot.draw(found, "net_plan", ax=Figure().add_subplot(projection="3d"))
    with pytest.raises(ValueError, match="is not whole"):
        plot.figures(found.to_dict() | {"cable_net": None})


def test_the_command_writes_files(study, tmp_path, capsys):
    path = tmp_path / "results.json"
    path.write_text(json.dumps(study))
    assert plot.main([str(path), "-o", str(tmp_path / "figures"), "--format", "svg"]) == 0
    assert len(capsys.readouterr().out.split()) == 5
    assert (tmp_path / "figures" / "length_errors.svg").read_text().startswith("<?xml")


@pytest.mark.parametrize(
    "text",
    ["", "[]", "{}", '{"format": "taut-plan"}', '{"format": "taut-net", "nodes": []}', "null"],
)
def test_what_is_no_result_is_refused_in_a_line(text, tmp_path, capsys):
    path = tmp_path / "results.json"
    path.write_text(text)
    assert plot.main([str(path), "-o", str(tmp_path / "figures")]) == 2
    assert "results.json" in capsys.readouterr().err
