#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Checks that other programs open what `taut export` writes, and see the same net in it.

Needs compas and meshio (pip install compas meshio), which Debian does not carry: run by hand.
Usage: check_exports.py TAUT [NET]     (NET: default hypar:5x7)
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import compas
import meshio
import numpy as np
from compas.datastructures import Graph


def main():
    taut = str(Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        net = Path(folder) / "net.json"
        if len(sys.argv) > 2:
            net.write_bytes(Path(sys.argv[2]).read_bytes())
        else:
            subprocess.run([taut, "example", "hypar:5x7", "-o", net], check=True)
        for target in ("compas", "obj", "vtk"):
            subprocess.run([taut, "export", net, "--to", target, "-o", f"{folder}/net.{target}"], check=True)
        check(json.loads(net.read_text()), Path(folder))
    print("compas", compas.__version__, "and meshio", meshio.__version__, "see the same net")


def check(net, folder):
    counts = (len(net["nodes"]), len(net["edges"]))
    unstressed = dict(zip(map(frozenset, net["edges"]), net["unstressed_lengths"]))

    graph = compas.json_load(folder / "net.compas")
    assert isinstance(graph, Graph)
    assert (graph.number_of_nodes(), graph.number_of_edges()) == counts
    assert sorted(graph.nodes_where(is_support=True)) == sorted(net["supports"])
    for edge in graph.edges():
        assert graph.edge_attribute(edge, "l0") == unstressed[frozenset(edge)]
        assert np.isclose(graph.edge_length(edge), graph.edge_attribute(edge, "l"), rtol=1e-12)

    obj = Graph.from_obj(folder / "net.obj")
    assert (obj.number_of_nodes(), obj.number_of_edges()) == counts

    mesh = meshio.read(folder / "net.vtk")
    lines = mesh.cells_dict["line"]
    assert (len(mesh.points), len(lines)) == counts
    assert np.array_equal(lines, net["edges"])
    assert np.array_equal(np.ravel(mesh.cell_data["unstressed_length"][0]), net["unstressed_lengths"])
    assert np.array_equal(np.flatnonzero(mesh.point_data["is_support"]), sorted(net["supports"]))
    tensions = [graph.edge_attribute(tuple(edge), "f") for edge in net["edges"]]
    assert np.array_equal(np.ravel(mesh.cell_data["tension"][0]), tensions)


main()
