# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Runs the Python that README.md and docs/ show, as it stands, and checks that something runs each
other block."""

import json
import re
import warnings
from pathlib import Path

import numpy as np
import pytest
import taut

ROOT = Path(__file__).parents[2]
CI = ".ci/run"
CONSUMER = "tests/consumer/CMakeLists.txt"

# Who runs the blocks of a language on which pages: a file that names the page. Those of sh are
# also run on each page that .ci/run hands to scripts/check_page.sh.
RUN_BY = {
    ("python", "README.md"): "tests/python/test_docs.py",
    ("python", "docs/python.md"): "tests/python/test_docs.py",
    ("python", "docs/howto.md"): "tests/python/test_docs.py",
    ("python", "docs/files.md"): "tests/python/test_docs.py",
    ("python", "docs/clusters.md"): "tests/python/test_docs.py",
    ("python", "docs/grasshopper.md"): "tests/python/test_docs.py",
    ("json", "docs/files.md"): "tests/python/test_docs.py",
    ("cpp", "README.md"): CONSUMER,
    ("cpp", "docs/linking.md"): CONSUMER,
    ("cmake", "docs/linking.md"): CONSUMER,
    ("c", "docs/linking.md"): "tests/consumer/run.cmake",
    ("sh", "docs/linking.md"): "tests/consumer/run.cmake",
}


def fenced(page):
    """Each block of a page: its language or "", its first line, its text, and whether the page says
    that it is not run."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for match in re.finditer(r"^```(.*)\n((?:.*\n)*?)```$", text, re.MULTILINE):
        is_left_out = text[: match.start()].rstrip().endswith("<!-- not run -->")
        line = text.count("\n", 0, match.start(2))
        yield match.group(1).strip(), line, match.group(2), is_left_out


NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:e[-+]?\d+)?")


def run(page, capsys):
    """Runs the Python of a page and gives its names. A block without a language shows what the one
    before it printed, numbers to 2 %."""
    names = {"__name__": "__main__"}
    printed = None
    for language, line, text, _ in fenced(page):
        if language == "python":
            capsys.readouterr()
            exec(compile("\n" * line + text, page, "exec"), names)
            printed = capsys.readouterr().out
        elif not language and printed is not None:
            where = f"{page}:{line}: shows other than what was printed:\n{printed}"
            assert NUMBER.sub("#", text).split() == NUMBER.sub("#", printed).split(), where
            numbers = [[float(one) for one in NUMBER.findall(of)] for of in (text, printed)]
            assert numbers[0] == pytest.approx(numbers[1], rel=0.02), where
            printed = None
    return names


def pages():
    paths = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [path.relative_to(ROOT).as_posix() for path in paths]


@pytest.mark.parametrize("page", pages())
def test_every_block_is_run_or_says_that_it_is_not(page):
    in_ci = re.findall(
        r"^ *step scripts/check_page\.sh (\S+)$", (ROOT / CI).read_text(), re.MULTILINE
    )
    for language, line, _, is_left_out in fenced(page):
        if not language or is_left_out or (language == "sh" and page in in_ci):
            continue
        runner = RUN_BY.get((language, page))
        assert runner, f"{page}:{line}: nothing runs this block of '{language}'"
        name = page.removesuffix(".md") if runner == CONSUMER else page
        assert Path(name).name in (ROOT / runner).read_text(), f"{runner} does not run {page}"


@pytest.mark.parametrize("page", pages())
def test_a_measured_block_names_the_script_that_writes_it(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    names = re.findall(r"^<!-- by (.*?) -->$", text, re.MULTILINE)
    assert len(names) == len(set(names)) == text.count("<!-- end -->")
    for name in names:
        assert (ROOT / name.split(":")[0]).exists(), f"{page}: {name} is not there"


def test_the_figures_of_the_summary_are_those_of_the_pages():
    page = (ROOT / "docs/validation.md").read_text(encoding="utf-8")
    head, rest = page.split("\n## ", 1)
    rows = re.findall(
        r"^\| (.*?) \| (.*?) \| .*? \| \[\w.*?\]\((.*?)#.*?\) \|$", head, re.MULTILINE
    )
    assert len(rows) >= 15
    for claim, figure, name in rows:
        text = (ROOT / "docs" / name).read_text(encoding="utf-8") if name else rest
        for number in re.findall(r"\d+(?:[.,]\d+)*(?:e-?\d+)?", re.sub(r"`.*?`", "", figure)):
            found = re.search(rf"(?<![\d.]){re.escape(number)}(?!\d)", text)
            assert found, f"{claim}: {number} is not on {name or 'the page'}"


def test_the_page_of_python(tmp_path, monkeypatch, capsys):
    for package in ("compas", "jax", "pandas", "scipy", "sklearn", "matplotlib"):
        pytest.importorskip(package)
    monkeypatch.chdir(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("default")
        names = run("docs/python.md", capsys)
    assert names["found"].trust == "passed"
    assert names["inside"].mean() > 0.9
    assert names["plan"].is_feasible
    assert names["best"].fun < 0.1 * names["distance"](names["start"])[0]
    assert (tmp_path / "turns.csv").exists()
    assert np.array_equal(names["again"].form, names["named"].form)


def test_the_page_by_task(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    run("docs/howto.md", capsys)
    assert (tmp_path / "figures" / "length_intervals.pdf").exists()


def test_the_page_on_clusters(capsys):
    pytest.importorskip("distributed")
    run("docs/clusters.md", capsys)


def test_the_page_on_grasshopper(capsys):
    assert "net_from_lines" in run("docs/grasshopper.md", capsys)


def test_the_lines_of_the_readme(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    net = taut.hypar(4, 4)
    net.save("net.json")
    columns = taut.simulate_survey(net, net.nodes, noise=5e-4, seed=1)
    rows = zip(*columns.values(), strict=True)
    lines = ["node,x,y,z,sx,sy,sz", *(",".join(map(str, row)) for row in rows)]
    Path("survey.csv").write_text("\n".join(lines) + "\n")
    assert "found" in run("README.md", capsys)
    assert Path("turns.csv").exists()


def test_the_files_that_the_page_of_files_shows(tmp_path, monkeypatch, capsys):
    whole, part = (text for kind, _, text, _ in fenced("docs/files.md") if kind == "json")
    net = taut.CableNet.from_json(whole)
    assert net.edge_id(1) == "BC"
    # The laws are those of a net of three edges.
    nodes = [[0, 0, 0], [1, 0, 0], [-1, 1, 0], [-1, -1, 0]]
    lengths = [0.998, 1.41, 1.41]
    three = taut.CableNet(nodes, [1, 2, 3], [[0, 1], [0, 2], [0, 3]], 1e5, lengths).to_dict()
    laws = json.loads("{" + part + "}")
    strands = taut.CableNet.from_json(json.dumps(three | laws))
    assert strands.to_dict()["tension_laws"] == laws["tension_laws"]
    stretched = taut.tensions(strands, strands.unstressed_lengths, strands.nodes)
    assert stretched[0] == pytest.approx(17050 * (1 / 0.998 - 1) / 0.0022)

    pytest.importorskip("h5py")
    monkeypatch.chdir(tmp_path)
    data = taut.Sampler(net := taut.hypar(2, 2)).draw(3)
    data.save("data.h5", net)
    names = run("docs/files.md", capsys)
    assert np.array_equal(names["X"], data.form_deviations)
    assert np.array_equal(names["Y"], data.length_deviations)
