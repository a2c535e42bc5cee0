# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a spectrum that is not Welch's, and a frequency of a record that shows none."""

import pickle

import numpy as np
import pytest
import taut


@pytest.fixture
def record():
    """Times, and a string of 6.2 Hz in two axes with noise."""
    random = np.random.default_rng(4)
    time = np.arange(8000) / 160
    signal = random.normal(0, 0.1, (8000, 2))
    for mode in (1, 2, 3, 5):
        for start in (0, 11.3, 26.1, 37):
            since = np.maximum(time - start, 0)
            signal[:, mode % 2] += (
                (time >= start) * np.exp(-0.2 * since) * np.sin(2 * np.pi * 6.2 * mode * since)
            )
    return time, signal


def test_a_record_has_its_fundamental(record):
    time, signal = record
    found = taut.frequency(time, signal)
    assert found.message == ""
    assert found.fundamental == pytest.approx(6.2, abs=3 * found.fundamental_std)
    assert found.fundamental_std < 0.03
    assert found.inharmonicity < 1e-3
    assert [peak["mode"] for peak in found.peaks] == [1, 2, 3, 5]
    assert f"{found.fundamental:.4f}" in repr(found)
    assert pickle.loads(pickle.dumps(found)).fundamental == found.fundamental
    assert found.to_dict()["candidates"][0]["probability"] > 0.95


def test_the_spectrum_is_that_of_scipy(record):
    signal_of = pytest.importorskip("scipy.signal")
    time, signal = record
    found = taut.frequency(time, signal)
    frequency, density = signal_of.welch(
        signal, 160, "hann", nperseg=1000, noverlap=500, nfft=2048, detrend="linear", axis=0
    )
    assert found.spectrum == pytest.approx(density.sum(axis=1), rel=1e-9)
    assert found.spectrum_step == pytest.approx(frequency[1])
    assert found.resolution == pytest.approx(0.16)


def test_one_peak_needs_a_range(record):
    time, signal = record
    sine = np.sin(2 * np.pi * 9.5 * time) + signal[:, 0] % 0.1
    assert taut.frequency(time, sine).fundamental is None
    found = taut.frequency(time, sine, search_range=(9, 10))
    assert found.fundamental == pytest.approx(9.5, abs=0.02)


def test_bad_arguments_are_named(record):
    time, signal = record
    for arguments, words in [
        ((time[:-1], signal), "time"),
        ((time, signal[:, :, None]), "signal"),
    ]:
        with pytest.raises(ValueError, match=words):
            taut.frequency(*arguments)
    with pytest.raises(ValueError, match="range"):
        taut.frequency(time, signal, search_range=(4, 3))
