# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Surveys from files, arrays and tables."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Iterable, Mapping
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from taut import _taut, calls


def _column(table: Any, name: str) -> NDArray[Any]:
    """A column of numbers of a data frame or mapping."""
    if np.ma.is_masked(table[name]):
        raise ValueError(f"{name}: has masked entries, expected a number everywhere")
    column = np.asarray(table[name])
    if column.dtype.kind not in "iuf":
        raise TypeError(f"{name}: got dtype {column.dtype.name}, expected numbers")
    return column


def _of_columns(columns: dict[str, NDArray[Any]]) -> NDArray[Any]:
    """Columns of one length, by name, beside each other."""
    if len({column.shape for column in columns.values()}) > 1:
        sizes = ", ".join(f"{name} {column.shape}" for name, column in columns.items())
        raise ValueError(f"source: has columns of the shapes {sizes}, expected one shape")
    return np.column_stack(list(columns.values()))


def _of_table(table: Any, ids: Any) -> tuple[NDArray[Any], Any, NDArray[Any] | None]:
    """Positions, names and standard deviations out of columns x, y, z, id, sx, sy, sz."""
    missing = [name for name in "xyz" if name not in table]
    if missing:
        raise ValueError(
            f"source: has the columns {', '.join(map(str, table))}, expected x, y and z, "
            "and where there are any id, sx, sy, sz"
        )
    positions = _of_columns({name: _column(table, name) for name in "xyz"})
    if ids is None and "id" in table:
        ids = table["id"]
        if len(ids) == len(positions):
            ids = np.asarray(ids)
    stds = {name: _column(table, name) for name in ("sx", "sy", "sz") if name in table}
    if 0 < len(stds) < 3:
        raise ValueError("source: has some of the columns sx, sy, sz, expected all or none")
    return positions, ids, _of_columns(stds) if stds else None


def _names(ids: object, count: int) -> list[str] | None:
    """Names as text. Whole numbers that went through floats lose their '.0'. An endless source of
    names is refused after one more than there are points."""
    if ids is None:
        return None
    if isinstance(ids, str) or not isinstance(ids, Iterable):
        raise TypeError(f"ids: got {type(ids).__name__}, expected a name of each point")
    names = []
    for one in itertools.islice(ids, count + 1):
        if isinstance(one, (float, np.floating)):
            one = "" if np.isnan(one) else int(one) if one == int(one) else one
        names.append("" if one is None else str(one))
    if len(names) > count:
        raise ValueError(f"ids: got more than {count} names, expected {count}")
    return names


def _noise(noise: Any, count: int) -> tuple[float | None, NDArray[np.float64] | None]:
    """One number for all, or one of each coordinate (count, 3): the number, the array."""
    if noise is None:
        return None, None
    if isinstance(noise, str):
        return _taut._length_given(noise, "noise"), None
    if isinstance(noise, bytes):
        raise TypeError(f"noise: got {noise!r}, expected a number of metres")
    if np.ndim(noise) == 0:
        return float(noise), None
    if np.ma.is_masked(noise):
        raise ValueError("noise: has masked entries, expected a number everywhere")
    if np.ndim(noise) == 1 and any(isinstance(one, str) for one in noise):
        noise = [_taut._length_given(one, "noise") for one in noise]
    array = np.asarray(noise, dtype=float)
    if array.shape == (3,):
        array = np.tile(array, (count, 1))
    return None, array


#: Of coordinates.
UNITS = ("mm", "cm", "m", "in", "ft", "us-ft")


def _text_of(name: str, value: Any) -> str:
    """An argument, or a number in SI units, as on the command line."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    takes_numbers = name in ("unit", "offset", "angle", "distance")
    if not takes_numbers or isinstance(value, bool) or not isinstance(value, Real):
        expected = "text or a number" if takes_numbers else "text"
        raise TypeError(f"{name}: got {type(value).__name__}, expected {expected}")
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{name}: got {number}, expected a finite number")
    if name == "unit":
        for unit in UNITS:
            if math.isclose(number, _taut._length_of_unit(unit), rel_tol=1e-7):
                return unit
        raise ValueError(f"unit: got {number:g}, expected the metres of one of {', '.join(UNITS)}")
    return f"{1e3 * number!r}mrad" if name == "angle" else f"{number!r}m"


def _text(name: str, value: Any) -> str:
    if name == "offset" and isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise ValueError(f"offset: got {len(value)} numbers, expected offset and deviation")
        return ":".join(_text_of(name, one) for one in value)
    return _text_of(name, value)


@calls.taking_old_names(control="control_points", range="distance", format="file_format")
def read_survey(
    net: _taut.CableNet,
    source: str | os.PathLike[str] | ArrayLike | Mapping[str, ArrayLike],
    *,
    ids: Iterable[object] | None = None,
    noise: ArrayLike | str | None = None,
    frame: str = "auto",
    control_points: str | os.PathLike[str] | None = None,
    unit: str | float | None = None,
    match: str = "auto",
    offset: str | float | tuple[float, float] | None = None,
    offsets: str | os.PathLike[str] | None = None,
    angle: str | float | None = None,
    distance: str | float | None = None,
    file_format: str | None = None,
    columns: str | None = None,
    separator: str | None = None,
    decimal: str | None = None,
    encoding: str | None = None,
) -> _taut.Survey:
    """A survey of the net's form, from whatever holds one.

    Args:
        net: that was surveyed.
        source: the path of a file (CSV, TXT, LandXML, JobXML, GSI, DXF, PTS, XYZ, observed
            angles and distances); or points: an array (k, 3), or a table with columns x, y, z and,
            where there are any, id, sx, sy, sz, as a pandas.DataFrame or a mapping of arrays [m].
        ids: names of the points of an array (k,), those of the net's nodes; without, each point
            belongs to the nearest node.
        noise: standard deviation of each coordinate, one number, '0.5mm', or of points (3,) or
            (k, 3), where the source has none [m], whatever the unit of the coordinates.
        frame: 'net', 'supports' (fitted to those that are named), or 'auto'.
        control_points: path of control points id, x, y, z in the net's frame, to fit the frame to.
        unit: of the coordinates, 'mm', 'cm', 'm', 'in', 'ft', 'us-ft', or its metres: 0.001;
            of points by default 'm'.
        match: find a point's node by its 'name', its 'place', or 'auto'.
        offset: of targets from the axis of the cable along the net's normal, and its standard
            deviation: '3mm:0.2mm', or one or two numbers [m].
        offsets: path of a table target, offset, std of offsets by a target's name or code.

    The rest is for files alone, where these do not say it:

        angle: standard deviation of each direction and zenith angle, '0.3mgon', or a number
            [rad]: then angles of the file without a unit are in rad, too.
        distance: standard deviation of each distance, '1mm+1.5ppm', or a number [m].
        file_format: 'table', 'xyz', 'pts', 'gsi', 'landxml', 'jobxml', 'gama', 'dxf'.
        columns: of a table, 'id,x,y,z,sx,sy,sz' in their order, '-' for one to leave out.
        separator: of a table, 'comma', 'semicolon', 'tab', 'blank'.
        decimal: sign of a table, 'point' or 'comma'.
        encoding: 'utf-8', 'utf-16', 'latin-1'.

    Returns:
        The survey. Its warnings and notes say how the source was understood.

    Raises:
        InputError: naming the file, the place in it and the rule.
            Rows of arrays and tables are counted from 1 there.
        ValueError, TypeError: for arrays of a wrong shape or dtype.
    """
    if not isinstance(net, _taut.CableNet):
        raise TypeError(f"net: got {type(net).__name__}, expected CableNet")
    if source is None:
        raise TypeError("source: got None, expected a path, points or a table")
    of_file = {
        "angle": angle, "distance": distance, "file_format": file_format, "columns": columns,
        "separator": separator, "decimal": decimal, "encoding": encoding,
    }  # fmt: skip
    given = {
        "frame": frame, "control_points": control_points, "unit": unit, "match": match,
        "offset": offset, "offsets": offsets, **of_file,
    }  # fmt: skip
    texts = {name: _text(name, value) for name, value in given.items() if value is not None}
    if isinstance(source, (str, os.PathLike)):
        if ids is not None:
            raise ValueError("ids: are for an array of points, and source is a file")
        std, stds = _noise(noise, 0)
        if stds is not None:
            raise ValueError("noise: got an array, expected one number for a file")
        return _taut._read_survey_file(net, source, std, texts)
    for name in of_file.keys() & texts.keys():
        raise ValueError(f"{name}: is for a file, and source holds points")
    positions: Any
    if isinstance(source, Mapping) or hasattr(source, "columns"):
        positions, ids, stds = _of_table(source, ids)
    else:
        positions, stds = source, None
    if stds is not None and noise is not None:
        raise ValueError("noise: is given by the columns sx, sy, sz of source, too: leave out one")
    count = np.shape(positions)[0] if np.ndim(positions) else 0
    in_metres = stds is None  # columns are in the unit of the coordinates
    std = None
    if in_metres:
        std, stds = _noise(noise, count)
    names = _names(ids, count)
    return _taut._survey_of_points(net, positions, names, stds, in_metres, std, texts)
