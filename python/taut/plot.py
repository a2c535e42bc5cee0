# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The figures of a net or a result, for print: python -m taut.plot result.json -o figures/

Of a net its plan; of a study (taut reproduce) those of the paper's section 5; of an
identification lengths, tensions and residuals; of a plan the form before and after, strokes and
tensions. In Python also of an equilibrium the heights, of a survey its nodes, and of a predicted
precision the standard deviations. In mm and kN.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut

try:
    import matplotlib as mpl
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure
except ImportError as _error:
    raise ImportError("taut.plot needs Matplotlib: pip install 'taut[plot]'") from _error

__all__ = ["draw", "figures", "save_figures"]

#: What a file of a result holds.
Result = dict[str, Any]

#: What draws a figure into axes, and the figure's height [inches].
Drawing = tuple[Callable[[Axes], None], float]

#: One column of a journal, and serif numbers as in its text.
STYLE: Any = {
    "font.size": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.6,
    "lines.linewidth": 0.9,
    "legend.frameon": False,
    "legend.handlelength": 1.2,
    "legend.columnspacing": 1.0,
    "legend.handletextpad": 0.4,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 300,
    "pdf.fonttype": 42,
}
COLUMN = 3.5  # inches
LOW, HIGH = 2.3, 3.0
BLUE, ORANGE, GREY = "#2563a8", "#d9480f", "#8a94a0"


def _legend(axes: Axes, columns: int) -> None:
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=columns)


def _plan_lines(net: Result, nodes: ArrayLike) -> Any:
    return np.asarray(nodes)[np.asarray(net["edges"])][:, :, :2]


def _in_plan(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def _dots(
    axes: Axes,
    places: NDArray[np.float64],
    values: NDArray[np.float64],
    label: str,
    least: float | None = None,
    most: float | None = None,
) -> None:
    """Numbers at places in plan, as colours."""
    x, y, _ = places.T
    dots = axes.scatter(x, y, c=values, s=9, cmap="viridis", vmin=least, vmax=most)
    axes.figure.colorbar(dots, ax=axes, label=label, location="top", shrink=0.8, aspect=40)
    _in_plan(axes)


def _net_in_plan(axes: Axes, net: Result, nodes: ArrayLike) -> None:
    adjustable = np.zeros(len(net["edges"]), dtype=bool)
    adjustable[net.get("adjustable", [])] = True
    lines = _plan_lines(net, nodes)
    axes.add_collection(LineCollection(lines[~adjustable], colors=GREY, linewidths=0.5))
    axes.add_collection(LineCollection(lines[adjustable], colors=ORANGE, linewidths=0.7))
    axes.autoscale_view()
    _in_plan(axes)


def _net(net: Result, nodes: ArrayLike) -> Drawing:
    def draw(axes: Axes) -> None:
        _net_in_plan(axes, net, nodes)
        places = np.asarray(nodes)[net["supports"]]
        axes.plot(*places[:, :2].T, "o", color="black", markersize=1.6, label="support")
        axes.plot([], [], color=ORANGE, label="adjustable edge")
        _legend(axes, 2)

    return draw, HIGH


def _net_alone(net: Result) -> Iterator[tuple[str, Drawing]]:
    yield "net_plan", _net(net, net["nodes"])


def _map(
    net: Result,
    nodes: ArrayLike,
    which: ArrayLike,
    values: ArrayLike,
    label: str,
    most: float | None = None,
) -> Drawing:
    """Numbers of nodes over the net in plan [mm]."""

    def draw(axes: Axes) -> None:
        axes.add_collection(
            LineCollection(_plan_lines(net, nodes), colors="#c8ced4", linewidths=0.4, zorder=0)
        )
        places = np.asarray(nodes)[np.asarray(which)]
        _dots(axes, places, 1e3 * np.asarray(values), f"{label} [mm]", 0.0, most)

    return draw, HIGH


def _free_nodes(net: Result) -> NDArray[Any]:
    """Supports that give way are free nodes, too."""
    stiffness = net.get("support_stiffness") or [None] * len(net["supports"])
    rigid = [node for i, node in enumerate(net["supports"]) if stiffness[i] is None]
    return np.setdiff1d(np.arange(len(net["nodes"])), rigid)


def _study(result: Result) -> Iterator[tuple[str, Drawing]]:
    net, sample, errors = result["cable_net"], result["sample"], result["errors"]
    free = _free_nodes(net)
    true, identified = np.array(sample["true"]), np.array(sample["identified"])
    yield "net_plan", _net(net, result["nominal_form"])

    index = np.arange(1, len(true) + 1)

    def deviations(axes: Axes) -> None:
        axes.plot(index, 1e3 * true, color=GREY, label=r"true $\Delta l_0$")
        axes.plot(index, 1e3 * identified, ":", color=BLUE, label=r"identified $\Delta l_0$")
        axes.plot(index, 1e3 * (identified - true), color=ORANGE, label="error")
        axes.set_xlabel("interior edge")
        axes.set_ylabel("length deviation [mm]")
        _legend(axes, 3)

    yield "length_deviations", (deviations, LOW)

    def of_all(axes: Axes) -> None:
        mean, std = 1e3 * np.array(errors["mean"]), 1e3 * np.array(errors["std"])
        if errors.get("all"):
            every = 1e3 * np.array(errors["all"])
            axes.plot(
                np.broadcast_to(index[:, None], every.shape).ravel(),
                every.ravel(),
                ".",
                color="#c8ced4",
                markersize=0.8,
                rasterized=True,
            )
        axes.plot(index, mean, color=BLUE, label="mean")
        axes.plot(index, mean + std, color=ORANGE, linewidth=0.6, label="mean ± standard deviation")
        axes.plot(index, mean - std, color=ORANGE, linewidth=0.6)
        axes.set_xlabel("interior edge")
        axes.set_ylabel("error of the identified length [mm]")
        _legend(axes, 2)

    yield "length_errors", (of_all, LOW)

    most = 1e3 * max(sample["form_error"]["nominal"])
    for which in ("nominal", "identified"):
        yield (
            f"form_error_{which}",
            _map(
                net,
                result["nominal_form"],
                free,
                sample["form_error"][which],
                f"form error, {which} lengths",
                most,
            ),
        )


def _intervals(
    axes: Axes, values: Any, lower: Any, upper: Any, wrong: NDArray[np.bool_] | None = None
) -> None:
    index = np.arange(1, len(values) + 1)
    order = np.argsort(values, kind="stable")
    axes.vlines(index, lower[order], upper[order], color=BLUE, linewidth=0.5, label="95 % interval")
    axes.plot(index, values[order], ".", color="black", markersize=1.5, label="estimate")
    if wrong is not None and wrong.any():
        axes.plot(
            index[wrong[order]],
            values[order][wrong[order]],
            "x",
            color=ORANGE,
            label="length outlier",
        )


def _identification(result: Result) -> Iterator[tuple[str, Drawing]]:
    net, edges = result["cable_net"], result["edges"]
    yield "net_plan", _net(net, result["form"])

    def column(name: str, of: Any = edges) -> NDArray[np.float64]:
        return np.array([np.nan if edge[name] is None else edge[name] for edge in of], dtype=float)

    outliers = {one["edge"] for one in (result.get("diagnostics") or {}).get("length_outliers", [])}
    wrong = np.array([edge["edge"] in outliers for edge in edges])

    def lengths(axes: Axes) -> None:
        off, lower, upper = (1e3 * column(name) for name in ("length_deviation", "lower", "upper"))
        _intervals(axes, off, lower, upper, wrong)
        axes.axhline(0.0, color=GREY, linewidth=0.5)
        axes.set_xlabel("interior edge, by its deviation")
        axes.set_ylabel("length deviation [mm]")
        _legend(axes, 3)

    yield "length_intervals", (lengths, LOW)

    every = sorted(edges + result.get("adjustable_edges", []), key=lambda edge: edge["edge"])
    if every and all(edge.get("tension_lower") is not None for edge in every):

        def tensions(axes: Axes) -> None:
            names = "tension", "tension_lower", "tension_upper"
            tension, lower, upper = (1e-3 * column(name, every) for name in names)
            _intervals(axes, tension, lower, upper)
            axes.axhline(0.0, color=GREY, linewidth=0.5)
            axes.set_xlabel("edge, by its tension")
            axes.set_ylabel("tension [kN]")
            _legend(axes, 2)

        yield "tension_intervals", (tensions, LOW)

    residuals = result["survey"]["residuals"]
    if residuals:
        sizes = [np.hypot(np.hypot(one["dx"], one["dy"]), one["dz"]) for one in residuals]
        nodes = [one["node"] for one in residuals]
        yield (
            "residual_map",
            _map(net, result["form"], nodes, sizes, "surveyed from predicted"),
        )


def _plan(result: Result) -> Iterator[tuple[str, Drawing]]:
    net = result["cable_net"]
    free = _free_nodes(net)
    target, normals = np.array(result["target_form"]), np.array(result["target_normals"])
    distances = {}
    for which in ("built", "planned"):
        off = np.array(result[f"{which}_form"]) - target
        distances[which] = np.abs(np.sum(off * normals, axis=1))[free]
    most = 1e3 * max(values.max() for values in distances.values())
    for which, values in distances.items():
        yield (
            f"plan_normal_{which}",
            _map(net, target, free, values, f"from the target along its normal, {which}", most),
        )

    turns = sorted(result["turns"], key=lambda turn: turn["stroke"])

    def strokes(axes: Axes) -> None:
        axes.bar(range(1, len(turns) + 1), [1e3 * turn["stroke"] for turn in turns], color=BLUE)
        axes.axhline(0.0, color="black", linewidth=0.5)
        axes.set_xlabel("turned edge, by its stroke")
        axes.set_ylabel("stroke, + lengthens [mm]")

    yield "plan_strokes", (strokes, LOW)

    edges = sorted(result["tension"]["edges"], key=lambda edge: edge["planned"])

    def tensions(axes: Axes) -> None:
        index = np.arange(1, len(edges) + 1)
        if all(edge["lower"] is not None for edge in edges):
            axes.vlines(
                index,
                [1e-3 * edge["lower"] for edge in edges],
                [1e-3 * edge["upper"] for edge in edges],
                color=BLUE,
                linewidth=0.5,
                label="95 % interval",
            )
        for name, label, color in (("as_built", "as built", GREY), ("planned", "planned", "black")):
            values = [1e-3 * edge[name] for edge in edges]
            axes.plot(index, values, ".", color=color, markersize=1.5, label=label)
        limit_label = "limit"
        for name in ("limit_lower", "limit_upper"):
            limits = [np.nan if edge[name] is None else 1e-3 * edge[name] for edge in edges]
            if np.isfinite(limits).any():
                axes.plot(index, limits, color=ORANGE, linewidth=0.7, label=limit_label)
                limit_label = "_limit"
        _legend(axes, 4)
        axes.set_xlabel("edge, by its planned tension")
        axes.set_ylabel("tension [kN]")

    yield "plan_tensions", (tensions, LOW)


def _equilibrium(found: _taut.Equilibrium) -> Iterator[tuple[str, Drawing]]:
    def heights(axes: Axes) -> None:
        _dots(axes, found.form, found.form[:, 2], "z [m]")

    yield "form_heights", (heights, HIGH)


def _survey(survey: _taut.Survey) -> Iterator[tuple[str, Drawing]]:
    def nodes(axes: Axes) -> None:
        supports = np.setdiff1d(range(len(survey.form)), [*survey.surveyed, *survey.missing])
        for which, marker, color, label in (
            (supports, "o", "black", "support"),
            (survey.surveyed, "o", BLUE, "surveyed"),
            (survey.missing, "x", ORANGE, "not surveyed"),
        ):
            x, y, _ = survey.form[which].T
            axes.plot(x, y, marker, color=color, markersize=2.5, label=label)
        _in_plan(axes)
        _legend(axes, 3)

    yield "survey_plan", (nodes, HIGH)


def _precision(precision: _taut.PredictedPrecision) -> Iterator[tuple[str, Drawing]]:
    def stds(axes: Axes) -> None:
        values = 1e3 * np.sort(precision.std)
        axes.plot(np.arange(1, len(values) + 1), values, color=BLUE, label="after the survey")
        axes.axhline(1e3 * precision.prior_std, color=GREY, linewidth=0.6, label="before")
        axes.set_ylim(bottom=0.0)
        axes.set_xlabel("interior edge, by its standard deviation")
        axes.set_ylabel("standard deviation [mm]")
        _legend(axes, 2)

    yield "length_stds", (stds, LOW)


_OF_OBJECTS: dict[type, Callable[[Any], Iterator[tuple[str, Drawing]]]] = {
    _taut.Equilibrium: _equilibrium,
    _taut.Survey: _survey,
    _taut.PredictedPrecision: _precision,
}
_OF = {
    "taut-net": _net_alone,
    "taut-study": _study,
    "taut-identification": _identification,
    "taut-plan": _plan,
}


@contextmanager
def _whole() -> Iterator[None]:
    try:
        yield
    except KeyError as error:
        raise ValueError(f"result: is not whole: it lacks {error}") from error
    except (LookupError, AttributeError, TypeError, ValueError) as error:
        raise ValueError(f"result: is not whole: {error}") from error


def _drawings(result: Any) -> dict[str, Drawing]:
    if type(result) in _OF_OBJECTS:
        return dict(_OF_OBJECTS[type(result)](result))
    got = type(result).__name__
    if isinstance(result, (_taut.CableNet, _taut.Identification, _taut.Plan)):
        result = result.to_dict()
    form = result.get("format") if isinstance(result, dict) else None
    if form not in list(_OF):
        raise ValueError(
            f"result: got {got if form is None else repr(form)}, which has no figures, expected "
            "CableNet, Equilibrium, Survey, PredictedPrecision, Identification, Plan, or a dict of "
            f"the format {', '.join(_OF)}"
        )
    status = result.get("status", "converged")
    if status != "converged":
        raise ValueError(f"result: has no lengths, its status is {status!r}")
    with _whole():
        return dict(_OF[form](result))


def figures(result: Any) -> dict[str, Figure]:
    """The figures of a net or a result: {name: matplotlib.figure.Figure}.

    Args:
        result: CableNet, Equilibrium, Survey, PredictedPrecision, Identification or Plan; what
            reproduce() returns; or what json.load() gives of net.json, results.json, result.json
            or plan.json.

    Raises:
        ValueError: for what is none of these.
    """
    made = {}
    drawings = _drawings(result)
    with mpl.rc_context(STYLE), _whole():
        for name, (draw_into, height) in drawings.items():
            made[name] = Figure(figsize=(COLUMN, height), layout="constrained")
            draw_into(made[name].add_subplot())
    return made


def draw(result: Any, name: str, *, ax: Axes | None = None) -> Axes:
    """One figure of a net or a result, in axes of your own.

    Args:
        result: as of figures().
        name: of the figure: a key of what figures() returns.
        ax: matplotlib.axes.Axes to draw into, by default those of pyplot.

    Returns:
        The axes.

    Raises:
        ValueError: where the result has no such figure, and for 3D or polar axes.
        TypeError: for an ax that is none.
    """
    drawings = _drawings(result)
    if name not in list(drawings):
        raise ValueError(f"name: got {name!r}, expected one of {', '.join(drawings)}")
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.gca()
    if not isinstance(ax, Axes):
        raise TypeError(f"ax: got {type(ax).__name__}, expected matplotlib.axes.Axes")
    if ax.name != "rectilinear":
        raise ValueError(f"ax: has the projection {ax.name!r}, expected plain axes")
    with _whole():
        drawings[name][0](ax)
    if ax.get_legend() is not None:
        ax.legend(loc="best")  # above the axes there may be a title
    return ax


def save_figures(result: Any, folder: str | Path, *, file_format: str = "pdf") -> list[Path]:
    """Writes the figures of a result into a folder, and gives their paths."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, figure in figures(result).items():
        paths.append(folder / f"{name}.{file_format}")
        with mpl.rc_context(STYLE):
            figure.savefig(paths[-1])
    return paths


def main(arguments: Sequence[str] | None = None) -> int:
    """python -m taut.plot"""
    parser = argparse.ArgumentParser(prog="python -m taut.plot", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "result", type=Path, help="net.json, result.json, results.json or plan.json"
    )
    parser.add_argument("-o", "--output", type=Path, required=True, help="folder of the figures")
    parser.add_argument("--format", choices=["pdf", "svg", "png"], default="pdf")
    given = parser.parse_args(arguments)
    try:
        result = json.loads(given.result.read_text(encoding="utf-8"))
        paths = save_figures(result, given.output, file_format=given.format)
    except (OSError, ValueError, TypeError) as error:
        print(f"taut.plot: {given.result}: {error}", file=sys.stderr)
        return 2
    for path in paths:
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
