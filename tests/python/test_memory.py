# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The memory limit of a call: what it counts is most of what a call takes."""

import subprocess
import sys

import pytest
import taut


@pytest.fixture(autouse=True)
def no_limit_afterwards():
    yield
    taut.set_memory_limit(None)


def test_a_call_beyond_the_limit_raises_memory_error():
    net = taut.hypar(20, 20)
    taut.set_memory_limit("1 MB")
    assert taut.memory_limit() == 1e6
    with pytest.raises(
        MemoryError, match=r"the call needs .* MiB or more, and may take 0\.95367 MiB"
    ):
        taut.Sampler(net, "uniform:3mm").draw(1000)
    taut.set_memory_limit(None)
    assert taut.memory_limit() is None
    assert len(taut.Sampler(net, "uniform:3mm").draw(10)) == 10


@pytest.mark.parametrize("limit", [0, -1, "8", "0GiB", "8 apples", float("nan")])
def test_a_wrong_limit_is_refused(limit):
    taut.set_memory_limit("2GiB")
    with pytest.raises(ValueError, match=r"limit|size of memory"):
        taut.set_memory_limit(limit)
    assert taut.memory_limit() == 2 * 1024**3


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks /proc")
@pytest.mark.parametrize(
    "work",
    [
        "taut.identify(net, survey, prior='normal:2mm', prior_exact=True)",
        "taut.train(net, data)",
    ],
)
def test_the_limit_counts_most_of_what_is_taken(work):
    """The least limit within which a call is done, against what the process took for it."""
    program = f"""
import re, taut
net = taut.hypar(40, 40)
survey = taut.read_survey(net, taut.simulate_survey(net, net.nodes, noise=5e-4))
wide = taut.hypar(20, 20)
data = taut.Sampler(wide, "uniform:3mm", seed=1).draw(300)
if "train" in {work!r}:
    net = wide
def peak():
    status = open('/proc/self/status').read()
    return 1024 * int(re.search(r'VmHWM:\\s+(\\d+)', status)[1])
# Threads and libraries take some once.
small = taut.hypar(9, 9)
taut.identify(small, taut.read_survey(small, taut.simulate_survey(small, small.nodes, noise=5e-4)))
before = peak()
kept = {work}
taken = peak() - before
limit = 0.5 * taken
while True:
    limit *= 1.15
    taut.set_memory_limit(limit)
    try:
        kept = {work}
        break
    except MemoryError:
        pass
print(limit / taken)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert 0.5 < float(done.stdout) < 1.6
