# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Results as tables of pandas, which is imported when the first is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut

if TYPE_CHECKING:
    import pandas


def _frame(columns: dict[str, Any], index: str) -> pandas.DataFrame:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_dataframe needs pandas: pip install pandas") from error
    return pandas.DataFrame(columns).set_index(index)


def _edges(net: _taut.CableNet) -> dict[str, Any]:
    edges = np.asarray(net.edges)
    return {
        "edge": np.arange(len(edges)),
        "id": [net.edge_id(k) for k in range(len(edges))],
        "start": [net.node_id(int(k)) for k in edges[:, 0]],
        "end": [net.node_id(int(k)) for k in edges[:, 1]],
    }


def net_frame(net: _taut.CableNet) -> pandas.DataFrame:
    """CableNet.to_dataframe()."""
    adjustable = np.zeros(len(net.edges), dtype=bool)
    adjustable[net.adjustable_edges] = True
    return _frame(
        _edges(net)
        | {
            "unstressed_length": np.array(net.unstressed_lengths),
            "axial_stiffness": np.array(net.axial_stiffness),
            "is_adjustable": adjustable,
        },
        "edge",
    )


def identification_columns(found: _taut.Identification) -> dict[str, Any]:
    """Of all edges by name, as Identification.to_dataframe() has them, without pandas."""
    net = found.net
    columns = _edges(net)
    interior = found.edge
    count = len(net.edges)

    def of_all(values: ArrayLike) -> NDArray[np.float64]:
        column = np.full(count, np.nan)
        column[interior] = values
        return column

    status = np.full(count, "adjustable", dtype=object)
    status[interior] = found.edge_status
    columns |= {
        "status": status,
        "nominal": np.array(net.unstressed_lengths),
        "length_deviation": of_all(found.length_deviation),
        "std": of_all(found.std),
        "lower": of_all(found.lower),
        "upper": of_all(found.upper),
    }
    for name in ("tension", "tension_lower", "tension_upper", "slack_probability"):
        values = np.array(getattr(found, name))
        if len(values) == count:
            columns[name] = values
    return columns


def identification_frame(found: _taut.Identification) -> pandas.DataFrame:
    """Identification.to_dataframe()."""
    return _frame(identification_columns(found), "edge")


def plan_frame(plan: _taut.Plan) -> pandas.DataFrame:
    """Plan.to_dataframe()."""
    net = plan.net
    edges = np.asarray(plan.edges, dtype=int)
    pairs = np.asarray(net.edges)
    return _frame(
        {
            "edge": edges,
            "id": [net.edge_id(int(k)) for k in edges],
            "start": [net.node_id(int(k)) for k in pairs[edges, 0]],
            "end": [net.node_id(int(k)) for k in pairs[edges, 1]],
            "stroke": np.array(plan.strokes),
            "tension": np.array(plan.tension)[edges],
        },
        "edge",
    )


def precision_frame(precision: _taut.PredictedPrecision) -> pandas.DataFrame:
    """PredictedPrecision.to_dataframe()."""
    columns = {"edge": precision.edge, "std": precision.std, "status": precision.edge_status}
    return _frame(columns, "edge")


def survey_frame(survey: _taut.Survey, net: _taut.CableNet) -> pandas.DataFrame:
    """Survey.to_dataframe()."""
    if len(survey.form) != len(net.nodes):
        raise ValueError(
            f"net: has {len(net.nodes)} nodes, expected the survey's net of {len(survey.form)}"
        )
    nodes = np.asarray(survey.surveyed, dtype=int)
    form = np.asarray(survey.form)[nodes]
    columns = {"node": nodes, "id": [net.node_id(int(k)) for k in nodes]}
    columns |= dict(zip("xyz", form.T))
    noise = np.asarray(survey.noise_std)
    if len(noise):
        columns |= dict(zip(("sx", "sy", "sz"), noise[nodes].T))
    return _frame(columns, "node")
