#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes struts_reference.json: forms of nets with struts found by MusclePy, for tests/statics.

    python3 -m venv build/venv/muscle && build/venv/muscle/bin/pip install musclepy==1.1.0
    build/venv/muscle/bin/python tests/data/make_struts_reference.py

MusclePy (Universite catholique de Louvain) finds them by dynamic relaxation, without a line of taut. Its
struts carry compression alone and its cables tension alone; here all do. The simplex is that of J. Feron, L.
Rhode-Barbarigos and P. Latteur (J. Struct. Eng. 149, 2023) on rigid feet, under the loads of its test, with a
cable shortened by 35 mm.
"""

import json
from pathlib import Path

import musclepy
import numpy as np

MODULUS = 70e3  # MPa; areas follow from EA


def solve(net):
    nodes, edges = np.array(net["nodes"], float), np.array(net["edges"])
    is_strut = np.isin(np.arange(len(edges)), net["struts"])
    free = np.ones(nodes.shape, bool)
    free[net["supports"]] = False
    spans = np.linalg.norm(nodes[edges[:, 0]] - nodes[edges[:, 1]], axis=1)
    elements = musclepy.PyElements(
        nodes=musclepy.PyNodes(initial_coordinates=nodes, dof=free, loads=np.zeros_like(nodes)),
        type=np.where(is_strut, -1, 1),
        end_nodes=edges,
        area=np.array(net["axial_stiffness"]) / MODULUS,
        youngs=np.where(is_strut[:, None], [[MODULUS, 0]], [[0, MODULUS]]),
        free_length=spans,
        tension=np.zeros(len(edges)),
    )
    exact = musclepy.PyConfigDR(
        max_time_step=100000, max_ke_reset=10000, zero_residual_rtol=1e-9, zero_residual_atol=1e-6
    )
    found = musclepy.main_dynamic_relaxation(
        musclepy.PyTruss(elements.nodes, elements),
        np.array(net["loads"], float),
        np.array(net["unstressed_lengths"]) - spans,
        exact,
    )
    print(f"{net['name']}: {exact.n_time_step} steps")
    assert exact.n_time_step < exact.max_time_step
    return net | {
        "form": found.nodes.coordinates.tolist(),
        "tensions": found.elements.tension.tolist(),
    }


def simplex():
    nodes = [[0.0, -2.0438, 0.0], [0.0, 0.0, 0.0], [1.77, -1.0219, 0.0]]
    nodes += [[0.59, -2.2019, 1.95], [-0.4319, -0.4319, 1.95], [1.6119, -0.4319, 1.95]]
    edges = [(2, 4), (1, 3), (0, 5), (4, 5), (3, 4), (3, 5), (2, 5), (1, 4), (0, 3)]
    nodes = np.array(nodes)
    lengths = np.array([np.linalg.norm(nodes[s] - nodes[t]) for s, t in edges])
    lengths[:3] += 0.835e-3
    lengths[5] -= 35e-3
    loads = np.zeros((6, 3))
    loads[3:, 2] = -41.6
    return {
        "name": "simplex",
        "nodes": nodes.tolist(),
        "supports": [0, 1, 2],
        "edges": edges,
        "axial_stiffness": [70390 * 364.4] * 3 + [71750 * 50.3] * 3 + [72190 * 50.3] * 3,
        "unstressed_lengths": lengths.tolist(),
        "loads": loads.tolist(),
        "struts": [0, 1, 2],
    }


def main():
    reference = {
        "SPDX-FileCopyrightText": "2026 The taut authors",
        "SPDX-License-Identifier": "MIT",
        "made_by": "build/venv/muscle/bin/python tests/data/make_struts_reference.py",
        "nets": [solve(simplex())],
    }
    path = Path(__file__).with_name("struts_reference.json")
    path.write_text(json.dumps(reference, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
