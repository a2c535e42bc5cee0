#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Value and gradient of a function of a net's form, by taut and by JAX FDM, in one run.

The function is the squared distance of the nodes from other places. taut finds the form of
elastic cables of given unstressed lengths, which takes several linear systems; its gradient is by
these lengths. JAX FDM finds the form for given force densities, which is one linear system; its
gradient is by these. Both through JAX, compiled, float64.

    pip install . jax jax_fdm
    python benchmarks/forms.py [--write]
"""

import argparse
import time

import jax
import jax.numpy as jnp
import numpy as np
import taut
from jax_fdm.datastructures import FDNetwork
from jax_fdm.equilibrium import (
    EquilibriumModelSparse,
    EquilibriumParametersState,
    EquilibriumStructureSparse,
    LoadState,
)
from page_block import show
from taut.gradients import jax_form

jax.config.update("jax_enable_x64", True)


def seconds(call, argument):
    """Median of a call, compiled before. Each with another argument: taut keeps solutions."""
    jax.block_until_ready(call(argument))
    random = np.random.default_rng(1)
    times = []
    while len(times) < 5 or (sum(times) < 2.0 and len(times) < 100):
        changes = 1.0 + 1e-3 * random.standard_normal(argument.shape)
        changed = jax.block_until_ready(argument * changes)
        start = time.perf_counter()
        jax.block_until_ready(call(changed))
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def fdm_form(net):
    """Places of the nodes for force densities, and the force densities of the design."""
    places, edges = np.array(net.nodes), np.array(net.edges)
    network = FDNetwork.from_nodes_and_edges(places.tolist(), edges.tolist())
    for node in np.setdiff1d(np.arange(len(places)), net.free_nodes):
        network.node_support(int(node))
    structure = EquilibriumStructureSparse.from_network(network)
    model = EquilibriumModelSparse(tmax=1)
    lengths = np.linalg.norm(places[edges[:, 0]] - places[edges[:, 1]], axis=1)
    order = {tuple(sorted(edge)): i for i, edge in enumerate(edges.tolist())}
    own = [order[tuple(sorted((int(u), int(v))))] for u, v in structure.edges]
    tensions = taut.tensions(net, net.unstressed_lengths, places)
    fixed = jnp.array(places[np.array(structure.nodes_fixed)])
    loads = LoadState(nodes=jnp.zeros((len(places), 3)), edges=0.0, faces=0.0)

    def form(q):
        return model(EquilibriumParametersState(q, fixed, loads), structure).xyz

    return form, jnp.array((tensions / lengths)[own])


def with_gradient(form, target):
    return jax.value_and_grad(lambda at: ((form(at) - target) ** 2).sum())


def rows():
    for size in (10, 30, 60):
        net = taut.hypar(size, size)
        places = jnp.array(net.nodes)
        target = places + 0.01 * np.random.default_rng(1).standard_normal(places.shape)
        of_taut, of_fdm = jax_form(net), fdm_form(net)
        lengths = jnp.array(net.unstressed_lengths)
        for place in (of_taut(lengths), of_fdm[0](of_fdm[1])):
            np.testing.assert_allclose(place, places, atol=1e-6)  # both find the design
        (form, both), (fdm, fdm_both) = (
            (seconds(jax.jit(of), at), seconds(jax.jit(with_gradient(of, target)), at))
            for of, at in ((of_taut, lengths), of_fdm)
        )
        yield (
            f"| {len(net.free_nodes)} | {1e3 * form:.2f} | {1e3 * both:.2f} | {1e3 * fdm:.2f} | "
            f"{1e3 * fdm_both:.2f} | {fdm_both / both:.1f} |"
        )


def lines():
    yield "Milliseconds, by `python benchmarks/forms.py --write`:"
    yield ""
    yield (
        "| free nodes | taut: form | form and gradient | JAX FDM: form | form and gradient | "
        "over taut |"
    )
    yield "|---|---|---|---|---|---|"
    yield from rows()


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__).add_argument("--write", action="store_true")
    show("performance.md", __file__, lines())
