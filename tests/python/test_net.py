# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a net that is not the one whose arrays went in."""

import copy
import gc
import json
import pickle

import numpy as np
import pytest
import taut
from taut import gradients


def arrays():
    """A node in the middle of four supports."""
    nodes = np.array([[0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]], dtype=float)
    return {
        "nodes": nodes,
        "supports": [1, 2, 3, 4],
        "edges": [(0, 1), (0, 2), (0, 3), (0, 4)],
        "axial_stiffness": 100e3,
        "unstressed_lengths": np.full(4, 0.99),
        "adjustable": [3],
    }


def test_a_net_is_made_of_arrays_and_gives_them_back():
    data = arrays()
    net = taut.CableNet(**data, name="cross", node_ids=list("abcde"))
    assert np.array_equal(net.nodes, data["nodes"])
    assert np.array_equal(net.edges, data["edges"])
    assert net.interior_edges.tolist() == [0, 1, 2]
    assert net.adjustable_edges.tolist() == [3]
    assert net.node_id(4) == "e"
    assert np.array_equal(net.axial_stiffness, np.full(4, 100e3))
    assert repr(net) == (
        "CableNet('cross': 1 free nodes, 4 supports, 3 interior and 1 adjustable edges)"
    )


def test_runs_slide_where_they_are_said_to():
    ridge = taut.builtin_net("sliding-ridge")
    (run,) = ridge.to_dict()["runs"]
    settings = {
        "supports": ridge.supports,
        "nodes": ridge.nodes,
        "edges": ridge.edges,
        "axial_stiffness": ridge.axial_stiffness,
        "unstressed_lengths": ridge.unstressed_lengths,
        "adjustable": ridge.adjustable_edges,
        "runs": {"ridge": run["edges"]},
    }
    clamped = taut.CableNet(**settings)
    assert clamped.fingerprint != ridge.fingerprint
    slides_at = {"ridge": run["slides_at"]}
    same = taut.CableNet(**settings, slides_at=slides_at, friction={"ridge": run["friction"]})
    assert same.fingerprint == ridge.fingerprint
    with pytest.raises(ValueError, match="friction: got 'valley', expected one of runs"):
        taut.CableNet(**settings, friction={"valley": 0.1})

    smooth = taut.CableNet(**settings, slides_at=slides_at)
    longer = smooth.unstressed_lengths.copy()
    longer[run["edges"][0]] += 0.05
    found = taut.solve_equilibrium(smooth, longer)
    assert found.is_balanced
    assert np.isclose(found.unstressed_lengths.sum(), longer.sum(), atol=1e-12)
    assert np.abs(found.unstressed_lengths - longer).max() > 0.01
    # Derivatives are those of the net that has slid.
    change = np.zeros_like(longer)
    change[run["edges"][0]] = 1e-5
    form, pullback = gradients.form_vjp(smooth, longer)
    weights = np.sin(np.arange(form.size)).reshape(form.shape)
    ahead = taut.solve_equilibrium(smooth, longer + change).form
    behind = taut.solve_equilibrium(smooth, longer - change).form
    expected = np.sum(weights * (ahead - behind)) / 2e-5
    assert np.isclose(pullback(weights)[run["edges"][0]], expected, rtol=1e-5)

    survey = taut.read_survey(ridge, taut.simulate_survey(ridge, ridge.nodes, noise=5e-4, seed=1))
    result = taut.identify(ridge, survey, prior="normal:2mm", uncertain=["none"], draws=20)
    (stretch,) = result.stretches
    assert np.array_equal(stretch["edges"], run["edges"])
    assert stretch["friction"] == pytest.approx(0.15)
    slips = [one for one in result.uncertain if one["parameter"] == "slip:100mm"]
    assert len(slips) == len(run["slides_at"])
    assert taut.plan(result).is_feasible


def test_struts_are_a_kind_of_edges(tmp_path):
    dome = taut.cable_dome()
    struts = np.array([kind == "strut" for kind in dome.kind])
    assert np.count_nonzero(struts) == 25
    assert dome.buckling_load.size == 0
    assert taut.smallest_stiffness(dome) > 1e3
    settings = {
        "supports": dome.supports,
        "nodes": dome.nodes,
        "edges": dome.edges,
        "axial_stiffness": dome.axial_stiffness,
        "unstressed_lengths": dome.unstressed_lengths,
        "kind": dome.kind,
    }
    assert dome.cable_ends == []
    again = taut.CableNet(**settings, buckling_load=5e4, cable_ends="hinged")
    assert again.cable_ends == len(dome.edges) * ["hinged"]
    assert taut.CableNet.from_json(again.to_json()).cable_ends == again.cable_ends
    with pytest.raises(ValueError, match="cable_ends: got 'pinned'"):
        taut.CableNet(**settings, cable_ends="pinned")
    assert again.fingerprint == dome.fingerprint
    assert np.array_equal(again.buckling_load == 5e4, struts)
    again.save(tmp_path / "dome.json")
    assert taut.CableNet.load(tmp_path / "dome.json").kind == dome.kind
    with pytest.raises(taut.NetError, match="kind"):
        taut.CableNet(**settings | {"kind": ["strut"]})
    with pytest.raises(ValueError, match="expected 'cable' or 'strut'"):
        taut.CableNet(**settings | {"kind": ["beam"]})
    with pytest.raises(taut.NetError, match="cable"):
        taut.CableNet(**settings, buckling_load=np.full(len(dome.edges), 5e4))


def heavy_net(sag_weight="mass"):
    """`hypar:5x5` with 32 m between nodes, of cables of 10 kg/m, in balance."""
    small = taut.hypar(5, 5)
    spans = np.linalg.norm(small.nodes[small.edges[:, 0]] - small.nodes[small.edges[:, 1]], axis=1)
    strain = spans / small.unstressed_lengths - 1
    tension, spans = 60e3 * strain / strain.mean(), 240 * spans
    settings = {
        "supports": small.supports,
        "edges": small.edges,
        "axial_stiffness": 60e6,
        "unstressed_lengths": spans / (1 + tension / 60e6) * (1 + (98 * spans / tension) ** 2 / 24),
        "mass": 10.0,
    }
    flat = taut.CableNet(nodes=240 * small.nodes, sag_weight="mass", **settings)
    form = taut.EquilibriumSolver(flat).solve(flat.unstressed_lengths).form
    return taut.CableNet(nodes=form, sag_weight=sag_weight, **settings)


def test_cables_sag(tmp_path):
    net = heavy_net()
    across = np.abs(net.nodes[net.edges[:, 0]] - net.nodes[net.edges[:, 1]])[:, :2]
    spans = np.linalg.norm(net.nodes[net.edges[:, 0]] - net.nodes[net.edges[:, 1]], axis=1)
    # Of the slope in the form that the weights were found in, a little off the one in balance.
    assert np.allclose(net.sag_weight, 98.0665 * np.hypot(*across.T) / spans, rtol=1e-9)
    net.save(tmp_path / "net.json")
    assert np.array_equal(taut.CableNet.load(tmp_path / "net.json").sag_weight, net.sag_weight)
    assert heavy_net(0.0).sag_weight.size == 0
    with pytest.raises(taut.NetError, match="sag_weight"):
        heavy_net(-1.0)
    with pytest.raises(ValueError, match="expected 'mass'"):
        heavy_net("weight")


def as_built(net, deviations, noise, random):
    """Lengths and form of a net as it might be built, and its survey."""
    lengths = net.unstressed_lengths.copy()
    lengths[net.interior_edges] += deviations
    form = taut.EquilibriumSolver(net).solve(lengths).form
    places = (form + random.normal(0, noise, form.shape))[net.free_nodes]
    return lengths, form, taut.read_survey(net, places, ids=net.free_nodes, noise=noise)


def least_tension(plan, folder):
    """As saved."""
    plan.save(folder / "plan.json")
    return json.loads((folder / "plan.json").read_text())["tension"]["least"]


def test_sag_goes_through_identification_and_a_plan(tmp_path):
    net = heavy_net()
    random = np.random.default_rng(4)
    deviations = 5e-3 * random.normal(size=len(net.interior_edges))
    lengths, form, survey = as_built(net, deviations, 1e-3, random)
    found = taut.identify(net, survey, prior="normal:5mm")
    built = taut.tensions(net, lengths, form)
    assert np.mean((found.tension_lower <= built) & (built <= found.tension_upper)) > 0.9
    plan = taut.plan(found, stroke=0.03, tension=(20e3, 200e3))
    assert plan.is_feasible
    assert least_tension(plan, tmp_path) > 20e3


def test_struts_go_through_identification_and_a_plan(tmp_path):
    dome = taut.cable_dome()
    random = np.random.default_rng(3)
    deviations = random.uniform(-1e-3, 1e-3, len(dome.interior_edges))
    _, _, survey = as_built(dome, deviations, 0.5e-3, random)
    found = taut.identify(dome, survey, prior="uniform:1mm")
    struts = np.array([kind == "strut" for kind in dome.kind])
    assert np.all(found.tension_upper[struts] < 0)
    plan = taut.plan(found, stroke=0.01, tension={None: (5e3, 9e4), "strut": (-4e4, 0.0)})
    assert plan.is_feasible
    assert np.all(plan.tension_upper[struts] < 0)
    assert least_tension(plan, tmp_path) < 0


def test_a_study_of_a_net_with_struts_is_written():
    study = taut.reproduce(taut.tensegrity_simplex(), prior="uniform:1mm", samples=40, validation=5)
    assert min(study["sample"]["true_tension"]) < 0
    assert min(study["sample"]["identified_tension"]) < 0


def on_springs():
    """The cross with a support that gives way along its cable, and one that does everywhere."""
    data = arrays()
    data["unstressed_lengths"] = np.full(4, 0.97)
    return taut.CableNet(
        **data,
        support_stiffness={1: [1e5, 3e5, 2e5], 3: 4e5},
        support_place={1: [1.02, 0.0, 0.0]},
    )


def test_supports_on_one_frame_pass_forces_on():
    net = taut.hypar(3, 3)
    supports = net.supports[:3]
    stiffness = 1e6 * np.kron(np.eye(3) - 0.2, np.diag([1.0, 2.0, 3.0]))
    framed = net.on_frame(stiffness, supports=supports)
    a, b, _ = supports.tolist()
    assert np.array_equal(framed.support_stiffness[a], stiffness[:3, :3])
    assert np.array_equal(framed.support_couplings[a, b], stiffness[:3, 3:6])
    form = taut.solve_equilibrium(framed).form
    assert np.abs(form - net.nodes).max() < 1e-9, "the frame balances the nominal form"
    # Pulled at one, another one moves, too, as the dense stiffness says.
    places = [framed.support_place[node] for node in supports]
    forces = stiffness @ (form[supports] - places).ravel()
    rigid = taut.CableNet(
        net.nodes, net.supports, net.edges, net.axial_stiffness, net.unstressed_lengths
    )
    tension = taut.tensions(rigid, net.unstressed_lengths, net.nodes)
    pulls = np.zeros_like(net.nodes)
    for (s, t), pull in zip(net.edges, tension, strict=True):
        along = net.nodes[t] - net.nodes[s]
        pulls[s] += pull * along / np.linalg.norm(along)
        pulls[t] -= pull * along / np.linalg.norm(along)
    assert forces == pytest.approx(pulls[supports].ravel(), rel=1e-6, abs=1e-6)
    assert pickle.loads(pickle.dumps(framed)) == framed
    assert net.on_frame(1e6 * np.eye(3 * len(net.supports))).support_couplings == {}
    with pytest.raises(ValueError, match="not symmetric"):
        net.on_frame(np.triu(stiffness), supports=supports)
    with pytest.raises(ValueError, match=r"expected 9 x 9"):
        net.on_frame(stiffness[:6, :6], supports=supports)
    with pytest.raises(ValueError, match="is no support"):
        net.on_frame(stiffness, supports=net.free_nodes[:3])
    with pytest.raises(taut.NetError, match="not positive definite"):
        net.on_frame(stiffness - 0.5e6 * np.eye(9), supports=supports)


def test_elastic_supports_are_free_nodes_that_give_way():
    net = on_springs()
    assert net.supports.tolist() == [2, 4, 1, 3]
    assert net.free_nodes.tolist() == [0, 1, 3]
    assert np.array_equal(net.support_stiffness[1], np.diag([1e5, 3e5, 2e5]))
    assert net.support_place[1].tolist() == [1.02, 0.0, 0.0]
    assert net.support_place[3].tolist() == [0.0, 1.0, 0.0]
    again = arrays() | {
        "supports": net.supports,
        "unstressed_lengths": net.unstressed_lengths,
        "support_stiffness": net.support_stiffness,
        "support_place": net.support_place,
    }
    assert taut.CableNet(**again).fingerprint == net.fingerprint
    assert pickle.loads(pickle.dumps(net)) == net
    balanced = taut.CableNet(**arrays(), support_stiffness={1: 1e5}, support_place="balanced")
    form = taut.EquilibriumSolver(balanced).solve(balanced.unstressed_lengths).form
    assert np.allclose(form, balanced.nodes, atol=1e-12)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"support_stiffness": {9: 1e5}}, r"support_stiffness\[9\]: is not among the supports"),
        ({"support_stiffness": {0: 1e5}}, r"support_stiffness\[0\]: is not among the supports"),
        ({"support_stiffness": {1: [1e5, 1e5]}}, r"support_stiffness\[1\]"),
        ({"support_stiffness": {1: -1e5}}, "symmetric and positive definite"),
        ({"support_place": {1: [1.0, 0.0, 0.0]}}, "is no node of support_stiffness"),
        ({"support_stiffness": {1: 1e5}, "support_place": "balance"}, "expected 'balanced'"),
    ],
)
def test_an_elastic_support_that_is_none_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        taut.CableNet(**arrays(), **wrong)


def test_a_net_goes_through_json_pickle_and_copy_to_the_last_bit(net, tmp_path):
    assert taut.CableNet.from_json(net.to_json()) == net
    assert pickle.loads(pickle.dumps(net)) == net
    assert copy.deepcopy(net) == net
    net.save(tmp_path / "net.json")
    loaded = taut.CableNet.load(tmp_path / "net.json")
    assert loaded == net
    assert hash(loaded) == hash(net)
    assert net.to_dict()["format"] == "taut-net"
    assert net != taut.hypar(4, 4)
    assert net != "net.json"
    assert net not in [None, 1]


def test_what_a_net_shows_is_read_only_its_own_and_outlives_it():
    data = arrays()
    net = taut.CableNet(**data)
    nodes = net.nodes
    with pytest.raises(ValueError, match="read-only"):
        nodes[0, 0] = 1.0
    data["nodes"][:] = 0.0
    del net
    gc.collect()
    assert nodes[1, 0] == 1.0


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"nodes": np.zeros((5, 2))}, ValueError, r"nodes.*\(5, 2\)"),
        ({"nodes": "abc"}, TypeError, "nodes"),
        ({"nodes": np.full((5, 3), np.nan)}, taut.NetError, "nodes"),
        ({"edges": [(0, 1, 2)]}, ValueError, "edges"),
        ({"edges": [(0.5, 1.0)] * 4}, TypeError, "edges"),
        ({"edges": [(0, 1), (0, 2), (0, 3), (0, 2**40)]}, ValueError, "edges"),
        ({"supports": [9]}, taut.NetError, "supports"),
        ({"axial_stiffness": [1.0, 2.0]}, ValueError, r"axial_stiffness.*\(2,\)"),
        ({"unstressed_lengths": [0.99] * 3}, ValueError, "unstressed_lengths"),
        ({"unstressed_lengths": [1j] * 4}, TypeError, "unstressed_lengths"),
    ],
)
def test_wrong_arrays_are_named(change, error, words):
    with pytest.raises(error, match=words):
        taut.CableNet(**(arrays() | change))


def test_errors_are_value_errors_that_name_the_file(tmp_path):
    path = tmp_path / "net.json"
    path.write_text('{"format": "taut-net", "version": 1, ')
    with pytest.raises(taut.InputError, match=r"net\.json:1:"):
        taut.CableNet.load(path)
    assert issubclass(taut.InputError, ValueError)
    assert issubclass(taut.NetError, ValueError)
    assert issubclass(taut.MissingInputError, taut.InputError)
    with pytest.raises(FileNotFoundError, match=r"absent\.json: cannot be read") as raised:
        taut.CableNet.load(tmp_path / "absent.json")
    assert isinstance(raised.value, taut.MissingInputError)
    with pytest.raises(OSError, match="folder"):
        taut.hypar(2, 2).save(tmp_path / "no folder" / "net.json")


def test_a_table_of_its_edges(net):
    pytest.importorskip("pandas")
    table = net.to_dataframe()
    assert len(table) == len(net.edges)
    assert table.is_adjustable.sum() == len(net.adjustable_edges)
    assert table.unstressed_length.iloc[7] == net.unstressed_lengths[7]


def test_tension_laws_are_checked():
    law = taut.TensionLaw([0.0, 0.001, 0.01], [0.0, 50.0, 1000.0], name="strand")
    net = taut.CableNet(**arrays(), tension_laws=[law], tension_law=[0, -1, -1, -1])
    assert net.to_dict()["tension_laws"][0]["name"] == "strand"
    with pytest.raises(ValueError, match="ascend"):
        taut.TensionLaw([0.0, 0.0], [0.0, 1.0])


def test_a_net_may_be_changed_by_its_dict():
    net = taut.builtin_net("steel-roof")
    assert taut.CableNet.from_dict(net.to_dict()) == net
    loads = 2.0 * np.array(net.to_dict()["loads"])
    heavier = taut.CableNet.from_dict(net.to_dict() | {"loads": loads})
    assert heavier.to_dict() == net.to_dict() | {"loads": loads.tolist()}
    with pytest.raises(ValueError, match="data:/edges"):
        taut.CableNet.from_dict(net.to_dict() | {"edges": 3})
