# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Runs the Python that README.md and docs/ show, as it stands."""

import re
import warnings
from pathlib import Path

import numpy as np
import pytest
import taut

ROOT = Path(__file__).parents[2]


def blocks(page):
    """The Python of a page, each block on the line where it stands there."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for match in re.finditer(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        line = text.count("\n", 0, match.start(1))
        yield compile("\n" * line + match.group(1), page, "exec")


def test_the_page_of_python(tmp_path, monkeypatch, capsys):
    for package in ("compas", "pandas", "scipy", "sklearn", "matplotlib"):
        pytest.importorskip(package)
    monkeypatch.chdir(tmp_path)
    names = {}
    count = 0
    with warnings.catch_warnings():
        warnings.simplefilter("default")
        for block in blocks("docs/python.md"):
            exec(block, names)
            count += 1
    assert count > 10
    assert "CableNet('hilo-quarter': 300 free nodes" in capsys.readouterr().out
    assert names["found"].trust == "passed"
    assert names["inside"].mean() > 0.9
    assert names["plan"].is_feasible
    assert names["best"].fun < 0.1 * names["distance"](names["start"])[0]
    assert (tmp_path / "turns.csv").exists()
    assert np.array_equal(names["again"].form, names["named"].form)


def test_the_page_by_task(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks("docs/howto.md"):
        exec(block, names)
    assert (tmp_path / "figures" / "length_intervals.pdf").exists()


def test_the_lines_of_the_readme(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    net = taut.hypar(4, 4)
    net.save("net.json")
    columns = taut.simulate_survey(net, net.nodes, noise=5e-4, seed=1)
    rows = zip(*columns.values(), strict=True)
    lines = ["node,x,y,z,sx,sy,sz", *(",".join(map(str, row)) for row in rows)]
    Path("survey.csv").write_text("\n".join(lines) + "\n")
    (block,) = blocks("README.md")
    exec(block, {})
    assert "Identification(" in capsys.readouterr().out
    assert Path("turns.csv").exists()
