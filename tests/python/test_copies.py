# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against results that other processes cannot take, or get with other bits."""

import concurrent.futures
import copy
import multiprocessing
import pickle

import numpy as np
import pytest
import taut


def same(a, b):
    """Whether two states are the same to the last bit."""
    if isinstance(a, (tuple, list)):
        return type(a) is type(b) and len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, np.ndarray):
        return a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, taut.CableNet):
        return a == b
    return repr(a) == repr(b)


@pytest.fixture(scope="module")
def results(net, survey, found):
    moved = np.array(found.form)
    moved[net.free_nodes[3], 2] += 0.05
    off = taut.read_survey(net, moved[net.free_nodes[1:]], ids=net.free_nodes[1:], noise=0.5e-3)
    data = taut.Sampler(net, "uniform:3mm", uncertain=["stiffness:5%"]).draw(30)
    unsure = {
        "uncertain": ["stiffness:5%", "supports:1mm"],
        "forces": [(3, float(found.tension[3]), 50.0)],
    }
    of_one = taut.identify(net, off, covariance_of=net.interior_edges[:2], **unsure)
    turned = [(int(net.adjustable_edges[0]), 1e-3, 1e-4)]
    of_two = taut.identify(net, off, epochs=[(survey, turned)], forces=unsure["forces"])
    return [
        taut.TensionLaw([0.0, 0.001], [0.0, 50.0], name="strand"),
        taut.solve_equilibrium(net),
        data,
        taut.train(net, data),
        taut._taut._fit_processes(data.form_deviations, data.length_deviations),
        survey,
        taut.read_survey(net, moved[net.free_nodes], noise=0.5e-3, frame="net"),
        found,
        of_one,
        of_two,
        taut.inspect(net),
        taut.plan(
            found,
            turn=2e-3,
            step=0.25,
            crews=2,
            tension=(100.0, None),
            thread="left",
            suggest_adjustable=1,
        ),
    ]


def test_results_are_pickled_and_copied_to_the_last_bit(results):
    for one in results:
        for again in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)):
            assert type(again) is type(one)
            assert repr(again) == repr(one)
            assert same(again.__getstate__(), one.__getstate__()), one


def test_what_is_made_of_a_pickled_result_is_the_same(net, found, survey):
    again = pickle.loads(pickle.dumps(found))
    assert again.to_json() == found.to_json()
    assert np.array_equal(again.length_draws, found.length_draws)
    assert taut.plan(again).to_json() == taut.plan(found).to_json()
    again = pickle.loads(pickle.dumps(survey))
    assert taut.identify(net, again, prior="uniform:3mm", draws=100).to_json() == found.to_json()
    plan = taut.plan(found)
    assert pickle.loads(pickle.dumps(plan)).to_csv() == plan.to_csv()
    solver = taut.EquilibriumSolver(net, relative_tolerance=1e-6)
    lengths = net.unstressed_lengths * 0.999
    form = pickle.loads(pickle.dumps(solver)).solve(lengths).form
    assert np.array_equal(form, solver.solve(lengths).form)


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_processes_hand_results_to_each_other(method, net, survey, found):
    context = multiprocessing.get_context(method)
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=context) as pool:
        there = pool.submit(taut.identify, net, survey, prior="uniform:3mm", draws=100).result(120)
        plan = pool.submit(taut.plan, there).result(120)
    assert there.to_json() == found.to_json()
    assert plan.to_json() == taut.plan(found).to_json()


def test_a_state_of_another_version_or_class_is_refused(found, survey):
    version, state = survey.__getstate__()
    with pytest.raises(ValueError, match=rf"by taut 0\.0\.1, this is {version}"):
        taut.Survey.__new__(taut.Survey).__setstate__(("0.0.1", state))
    for wrong in [(version, state[:-1]), (version, found.__getstate__()[1]), (version, 7)]:
        with pytest.raises((ValueError, TypeError, RuntimeError, IndexError)):
            taut.Survey.__new__(taut.Survey).__setstate__(wrong)


def test_a_sampler_goes_to_other_processes(net):
    sampler = taut.Sampler(net, "uniform:3mm", seed=7)
    parts = [pickle.loads(pickle.dumps(sampler)).part(k, 2) for k in (2, 0)]
    parts += [copy.copy(sampler).part(4, 1)]
    with pytest.raises(ValueError, match="count: got 2, expected 5 or more, as data has"):
        sampler.extend(sampler.draw(5), 2)
    assert same(sampler.joined(parts).form_deviations, sampler.draw(5).form_deviations)
