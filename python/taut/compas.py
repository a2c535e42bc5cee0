# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Nets from and to COMPAS 2 and JAX FDM, which are imported where they are needed."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from taut import _taut, calls

_net_of_compas = calls.naming_arguments(_taut._net_of_compas, "from_compas")


def _json_of(structure: Any) -> str:
    """A COMPAS structure as the JSON that compas.json_dump() writes."""
    try:
        import compas
    except ImportError as error:
        raise ImportError("from_compas needs COMPAS 2: pip install 'compas>=2'") from error
    if int(compas.__version__.split(".")[0]) < 2:
        raise ImportError(f"from_compas needs COMPAS 2, this is {compas.__version__}")
    from compas.data import json_dumps

    if not hasattr(structure, "edges") or not hasattr(structure, "__data__"):
        raise TypeError(
            f"structure: got {type(structure).__name__}, expected a COMPAS Mesh or Graph"
        )
    return str(json_dumps(structure))


def from_compas(
    structure: Any,
    *,
    name: str | None = None,
    select: str = "",
    axial_stiffness: float | None = None,
    young: float | None = None,
    diameter: float | None = None,
    diameter_attribute: str = "",
    force_unit: float | None = None,
    supports: Iterable[object] | None = None,
    boundary: bool = False,
    loads: str = "file",
    slides: str = "none",
) -> _taut.CableNet:
    """CableNet.from_compas()."""
    if isinstance(structure, (str, os.PathLike)):
        path = Path(structure)
        try:
            text = path.read_text(encoding="utf-8")
        except FileNotFoundError as error:
            raise _taut.MissingInputError(f"{path}: cannot be read: {error}") from error
        except (OSError, UnicodeDecodeError) as error:
            raise _taut.InputError(f"{path}: cannot be read: {error}") from error
        name = name or str(path)
    else:
        if select:
            raise ValueError("select: is for a file, and structure is none")
        text = _json_of(structure)
        name = name or getattr(structure, "name", None) or "compas"
    return _net_of_json(
        text,
        name,
        select,
        structure,
        axial_stiffness=axial_stiffness,
        young=young,
        diameter=diameter,
        diameter_attribute=diameter_attribute,
        force_unit=force_unit,
        supports=supports,
        boundary=boundary,
        loads=loads,
        slides=slides,
    )


def _net_of_json(
    text: str,
    name: str,
    select: str,
    structure: Any,
    *,
    supports: Iterable[object] | None,
    loads: str,
    **settings: Any,
) -> _taut.CableNet:
    if loads not in ("file", "balance", "none"):
        raise ValueError(f"loads: got {loads!r}, expected 'file', 'balance' or 'none'")
    if isinstance(supports, str) or not (supports is None or isinstance(supports, Iterable)):
        raise TypeError(
            f"supports: got {type(supports).__name__}, expected keys of the structure's nodes"
        )
    keys = None if supports is None else [str(one) for one in supports]
    net, notes = _net_of_compas(
        text=text, name=name, select=select, supports=keys, loads=loads, **settings
    )
    if notes["mean_tension"] == 0.0 and not np.any(net.loads):
        raise ValueError(
            f"structure: {name} has neither forces f nor force densities q of its edges, nor "
            "loads, expected those of its form: unstressed lengths follow from them"
        )
    if notes["left_out"]:
        missing = _left_out(structure, net) if hasattr(structure, "edges") else ""
        parts = ", ".join(notes["left_out"])
        warnings.warn(f"{name}: left out: {parts}{missing}", stacklevel=4)
    for warning in notes["warnings"]:
        warnings.warn(warning, stacklevel=4)
    return net


def _keys_by_name(structure: Any) -> dict[str, Any]:
    """The keys of a structure by the names that a net has of them: those of their attribute, where
    each has one of its own, else the keys as text."""
    is_mesh = hasattr(structure, "vertices")
    keys = list(structure.vertices() if is_mesh else structure.nodes())
    attribute = structure.vertex_attribute if is_mesh else structure.node_attribute
    names = [attribute(key, "name") for key in keys]
    if not all(isinstance(name, str) and name for name in names) or len({*names}) < len(names):
        names = [str(key) for key in keys]
    return dict(zip(names, keys))


def _left_out(structure: Any, net: _taut.CableNet) -> str:
    """The keys of the first five nodes and edges of a structure that its net does not have."""
    keys = _keys_by_name(structure)
    taken = {keys.get(net.node_id(node)): node for node in range(len(net.nodes))}
    edges = {frozenset(edge) for edge in np.asarray(net.edges).tolist()}
    missing = {
        "nodes": [key for key in keys.values() if key not in taken],
        "edges": [
            edge for edge in structure.edges() if frozenset(map(taken.get, edge)) not in edges
        ],
    }
    texts = [
        f"{what} {', '.join(map(str, those[:5]))}"
        + (f" and {len(those) - 5} more" if len(those) > 5 else "")
        for what, those in missing.items()
        if those
    ]
    return f" ({'; '.join(texts)})" if texts else ""


def to_compas(net: _taut.CableNet, form: ArrayLike | None = None, like: Any = None) -> Any:
    """CableNet.to_compas()."""
    try:
        from compas.data import json_loads
    except ImportError as error:
        raise ImportError("to_compas needs COMPAS 2: pip install 'compas>=2'") from error
    graph = json_loads(_taut._compas_of_form(net, form))
    return graph if like is None else _put_on(like, graph)


# Forces and lengths of edges in JAX FDM (FDNetwork, FDMesh) and COMPAS FoFin (CableMesh).
_OTHER_NAMES = {"force": "f", "_f": "f", "length": "l"}


def _fill_other_names(result: Any, is_mesh: bool, edges: list[Any]) -> None:
    """Fills the names that the structure's type has for forces and lengths of these edges, and for
    residuals of nodes, p - sum q (r_s - r_t): minus what a support gives, 0 at a free node."""
    for name in _OTHER_NAMES.keys() & result.default_edge_attributes.keys():
        for edge in edges:
            result.edge_attribute(edge, name, result.edge_attribute(edge, _OTHER_NAMES[name]))
    defaults = result.default_vertex_attributes if is_mesh else result.default_node_attributes
    if not {"rx", "_residual"} & defaults.keys():
        return
    attributes = result.vertex_attributes if is_mesh else result.node_attributes
    keys = list(result.vertices() if is_mesh else result.nodes())
    places = {key: np.array(attributes(key, "xyz"), dtype=float) for key in keys}
    loads = {key: [one or 0.0 for one in attributes(key, ("px", "py", "pz"))] for key in keys}
    residuals = {key: np.array(load, dtype=float) for key, load in loads.items()}
    for start, end in result.edges():
        if False in result.edge_attributes((start, end), ("is_edge", "_is_edge")):
            continue
        pull = (result.edge_attribute((start, end), "q") or 0.0) * (places[end] - places[start])
        residuals[start] += pull
        residuals[end] -= pull
    from compas.geometry import Vector

    for key, residual in residuals.items():
        if "rx" in defaults:
            attributes(key, ("rx", "ry", "rz"), residual.tolist())
        else:
            attributes(key, ("_residual",), [Vector(*residual.tolist())])


def _given(names: list[str], attributes: list[Any]) -> list[str]:
    """The names of attributes that any of the nodes or edges has."""
    return [name for name in names if any(one.get(name) is not None for one in attributes)]


def _put_on(like: Any, graph: Any) -> Any:
    """A copy of a Mesh or Graph with the places and forces of a graph that has its names."""
    if not hasattr(like, "copy"):
        raise TypeError(f"like: got {type(like).__name__}, expected a Mesh or Graph of COMPAS")
    is_mesh = hasattr(like, "vertices")
    result = like.copy()
    place = result.vertex_attributes if is_mesh else result.node_attributes
    keys = _keys_by_name(result)
    of_edges = _given(
        [
            "q",
            "f",
            "l",
            "l0",
            "EA",
            "is_slack",
            "is_adjustable",
            "is_strut",
            "sag_weight",
            "run",
            "friction",
        ],
        [graph.edge_attributes(edge) for edge in graph.edges()],
    )
    of_nodes = _given(
        ["x", "y", "z", "support_stiffness", "support_place", "slides"],
        [graph.node_attributes(node) for node in graph.nodes()],
    )
    names = {node: graph.node_attribute(node, "name") for node in graph.nodes()}
    absent = [name for name in names.values() if name not in keys]
    if absent:
        raise ValueError(
            f"like: got a {type(like).__name__} without the net's node {absent[0]!r}, expected "
            "the structure that the net was made of"
        )
    for node, name in names.items():
        place(keys[name], of_nodes, graph.node_attributes(node, of_nodes))
    edges = set(result.edges())
    filled = []
    for start, end in graph.edges():
        edge = keys[names[start]], keys[names[end]]
        if edge not in edges:
            edge = edge[::-1]
        if edge not in edges:
            raise ValueError(f"like: got a {type(like).__name__} without the net's edge {edge}")
        result.edge_attributes(edge, of_edges, graph.edge_attributes((start, end), of_edges))
        filled.append(edge)
    _fill_other_names(result, is_mesh, filled)
    return result


def from_jax_fdm(
    structure: Any,
    q: ArrayLike,
    *,
    axial_stiffness: ArrayLike,
    loads: ArrayLike | None = None,
    xyz_fixed: ArrayLike | None = None,
    name: str = "jax-fdm",
) -> _taut.CableNet:
    """CableNet.from_jax_fdm()."""
    fields = [getattr(structure, name, None) for name in ("nodes", "edges", "indices_fixed")]
    if any(one is None or callable(one) for one in fields):
        raise TypeError(
            f"structure: got {type(structure).__name__}, expected an EquilibriumStructure of "
            "JAX FDM"
        )
    keys, edges, fixed = (np.asarray(one, dtype=int) for one in fields)
    # Edges name nodes by their keys, which need be neither from 0 nor without gaps.
    index = {int(key): k for k, key in enumerate(keys)}
    edges = np.array([(index[int(s)], index[int(t)]) for s, t in edges], dtype=int)
    q = np.asarray(q, dtype=float)
    if q.shape != (len(edges),):
        raise ValueError(f"q: got the shape {q.shape}, expected ({len(edges)},)")
    if not (q > 0.0).all():
        worst = int(np.argmin(np.where(np.isnan(q), -np.inf, q)))
        raise ValueError(
            f"q: got {q[worst]} at edge {worst}, expected above 0: cables carry tension"
        )
    if xyz_fixed is None:
        raise ValueError("xyz_fixed: not given, expected the places of the fixed nodes (f, 3)")
    xyz_fixed = np.asarray(xyz_fixed, dtype=float)
    if xyz_fixed.shape != (len(fixed), 3):
        raise ValueError(f"xyz_fixed: got the shape {xyz_fixed.shape}, expected ({len(fixed)}, 3)")
    places = np.zeros((len(keys), 3))
    places[fixed] = xyz_fixed
    form = _taut.form_from_force_densities(places, fixed, edges, q, loads)
    lengths = np.linalg.norm(form[edges[:, 0]] - form[edges[:, 1]], axis=1)
    return _taut.CableNet(
        form,
        fixed,
        edges,
        axial_stiffness,
        _taut.unstressed_lengths_for(lengths, q * lengths, axial_stiffness),
        loads=loads,
        name=name,
        node_ids=[str(key) for key in keys],
    )
