# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against samples that depend on anything but prior, seed and number."""

import pickle

import numpy as np
import pytest
import taut


def test_a_sample_is_a_row(net):
    data = taut.Sampler(net, "uniform:5mm", seed=3).draw(20)
    assert data.length_deviations.shape == (20, len(net.interior_edges))
    assert data.form_deviations.shape == (20, 3 * len(net.free_nodes))
    lengths = np.array(net.unstressed_lengths)
    lengths[net.interior_edges] += data.length_deviations[7]
    form = taut.solve_equilibrium(net, lengths).form
    moved = form[net.free_nodes].ravel() - data.nominal_form
    assert moved == pytest.approx(data.form_deviations[7], abs=1e-9)


def test_a_data_set_is_extended_saved_and_loaded(net, tmp_path):
    sampler = taut.Sampler(net, seed=4)
    more = sampler.extend(sampler.draw(10), 25)
    assert len(more) == 25
    assert np.array_equal(more.form_deviations, sampler.draw(25).form_deviations)
    more.save(tmp_path / "data.h5", net)
    loaded, of_net = taut.DataSet.load(tmp_path / "data.h5")
    assert of_net == net
    assert np.array_equal(loaded.form_deviations, more.form_deviations)


def test_threads_change_nothing(net):
    expected = taut.Sampler(net, seed=5).draw(30).form_deviations
    before = taut.threads()
    try:
        taut.set_threads(1)
        assert np.array_equal(taut.Sampler(net, seed=5).draw(30).form_deviations, expected)
    finally:
        taut.set_threads(before)
    with pytest.raises(ValueError, match="threads"):
        taut.set_threads(-1)


def test_samples_and_models_stay_with_what_they_are_of(net, tmp_path):
    data = taut.Sampler(net, "uniform:3mm", seed=4).draw(5)
    for other in (
        taut.Sampler(net, "uniform:5mm", seed=4),
        taut.Sampler(net, "uniform:3mm", seed=5),
        taut.Sampler(net, "uniform:3mm", seed=4, uncertain=["stiffness:5%"]),
        taut.Sampler(taut.hypar(4, 4), "uniform:3mm", seed=4),
    ):
        with pytest.raises(ValueError, match=r"data: got one of .*expected one of this sampler"):
            other.extend(data, 10)
    cut = net.with_lengths(net.unstressed_lengths * 0.999)
    for result in (data, taut.train(net, data)):
        with pytest.raises(ValueError, match="net: got the one of fingerprint"):
            result.save(tmp_path / "x.h5", cut)


def test_wrong_counts_are_refused(net):
    with pytest.raises(ValueError, match="count"):
        taut.Sampler(net).draw(-1)
    with pytest.raises(ValueError, match="training sample 99"):
        taut.train(net, taut.Sampler(net).draw(5), samples=[0, 99])


def test_parts_join_to_what_one_call_draws(net):
    sampler = taut.Sampler(net, seed=7)
    parts = [sampler.part(first, 5) for first in (10, 0, 5)]
    parts = [pickle.loads(pickle.dumps(part)) for part in parts]
    joined = sampler.joined(parts)
    expected = sampler.draw(15)
    assert np.array_equal(joined.form_deviations, expected.form_deviations)


def test_dask_shares_samples_out(net):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        parts = client.map(lambda first: taut.Sampler(net, seed=7).part(first, 5), range(0, 20, 5))
        data = taut.Sampler(net, seed=7).joined(client.gather(parts))
    assert np.array_equal(data.form_deviations, taut.Sampler(net, seed=7).draw(20).form_deviations)
