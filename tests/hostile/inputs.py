# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Files that are almost right, by the grammar of each, and commands that read them."""

from __future__ import annotations

import json
import random
import re

ROOF_HEAD = b"ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n"

#: Numbers that no file should hold where another one stands.
NUMBERS = [
    0, -1, 1, -0.0, 1e-300, 1e-15, 1e15, 1e16, 1e155, 1e160, 1e308, -1e308, 2**31, 2**32, 2**63,
    2**64, 0.1, 1e9,
]  # fmt: skip
#: And values of another kind.
VALUES = [
    None, True, False, "", "x", "\x1b[31mred", "nan", "-1", [], {}, [[]], [1, 2], {"a": 1},
    "𝄞" * 50, "a" * 5000, "\u202eabc", "-",
]  # fmt: skip
#: What is put in between bytes of any text.
SNIPPETS = [
    b"", b"\x00", b"\xff", b",", b"\n", b"\r", b'"', b"[", b"{", b"nan", b"inf", b"-inf", b"1e999",
    b"\x1b[2J", b"\xef\xbb\xbf", b"1e308", b"-", b"0" * 400, b"," * 3000, b"\xc2\x9b", b"#",
    b"=1+1",
]  # fmt: skip


def places(value, path=()):
    """All places in a JSON value."""
    yield path
    if isinstance(value, dict):
        for key, one in value.items():
            yield from places(one, (*path, key))
    elif isinstance(value, list):
        for index, one in enumerate(value):
            yield from places(one, (*path, index))


def changed_json(rng: random.Random, text: bytes) -> bytes:
    """JSON with something else at one place or a few."""
    document = json.loads(text)
    for _ in range(rng.choice([1, 1, 1, 2, 5])):
        everywhere = list(places(document))
        path = rng.choice(everywhere[: 1 + len(everywhere)])
        if not path:
            continue
        parent = document
        for step in path[:-1]:
            parent = parent[step]
        action = rng.random()
        if action < 0.45:
            parent[path[-1]] = rng.choice(NUMBERS)
        elif action < 0.7:
            parent[path[-1]] = rng.choice(VALUES)
        elif action < 0.85:
            del parent[path[-1]]
        elif isinstance(parent, list):
            parent.insert(
                rng.randint(0, len(parent)), rng.choice([*NUMBERS, *VALUES, parent[path[-1]]])
            )
        else:
            parent[rng.choice(["extra", "nodes", "version", ""])] = rng.choice([*NUMBERS, *VALUES])
    return json.dumps(document, ensure_ascii=rng.random() < 0.5).encode("utf-8", "surrogatepass")


def changed_table(rng: random.Random, text: bytes) -> bytes:
    """A table with some cells, rows or separators other than they were."""
    rows = [line.split(b",") for line in text.split(b"\n")]
    for _ in range(rng.choice([1, 1, 2, 10])):
        row = rng.choice(rows)
        action = rng.random()
        if action < 0.4:
            row[rng.randrange(len(row))] = rng.choice([str(n).encode() for n in NUMBERS] + SNIPPETS)
        elif action < 0.55:
            row.append(rng.choice(SNIPPETS))
        elif action < 0.7:
            row.pop(rng.randrange(len(row)))
        elif action < 0.85:
            rows.insert(rng.randrange(len(rows)), list(rng.choice(rows)))
        else:
            rows.remove(row)
        rows = [r or [b""] for r in rows] or [[b""]]
    separator = rng.choice([b",", b",", b",", b";", b"\t", b" "])
    end = rng.choice([b"\n", b"\n", b"\r\n", b"\r"])
    return end.join(separator.join(row) for row in rows)


def changed_lines(rng: random.Random, text: bytes) -> bytes:
    """A text with numbers other than they were, and lines left out, doubled or in another place."""
    lines = text.split(b"\n")
    for _ in range(rng.choice([1, 1, 2, 10])):
        at = rng.randrange(len(lines))
        numbers = list(re.finditer(rb"[-+]?\d+(\.\d*)?", lines[at]))
        action = rng.random()
        if action < 0.6 and numbers:
            one = rng.choice(numbers)
            other = rng.choice([str(n).encode() for n in NUMBERS] + SNIPPETS)
            lines[at] = lines[at][: one.start()] + other + lines[at][one.end() :]
        elif action < 0.75:
            lines.insert(rng.randrange(len(lines)), lines[at])
        elif action < 0.9:
            del lines[at]
        else:
            other = rng.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
        lines = lines or [b""]
    return b"\n".join(lines)


def changed_bytes(rng: random.Random, data: bytes) -> bytes:
    """Any file with bytes flipped, cut, doubled or put in."""
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 8])):
        at = rng.randrange(len(data) + 1)
        action = rng.random()
        if action < 0.3 and at < len(data):
            data[at] ^= 1 << rng.randrange(8)
        elif action < 0.5:
            del data[at:]
        elif action < 0.7:
            data[at:at] = rng.choice(SNIPPETS)
        elif action < 0.85:
            length = rng.randrange(200)
            data[at:at] = data[at : at + length]
        else:
            del data[at : at + rng.randrange(1, 50)]
        if not data:
            break
    return bytes(data)


def changed(rng: random.Random, name: str, data: bytes) -> bytes:
    """A file of a name as its kind is changed."""
    if rng.random() < 0.3 or name.endswith(".h5"):
        return changed_bytes(rng, data)
    if name.endswith(".json"):
        return changed_json(rng, data)
    if name.endswith((".xml", ".jxl", ".dxf", ".gsi", ".obj", ".ply")):
        return changed_lines(rng, data)
    return changed_table(rng, data)


#: Sizes of what is too large, and what it is made of: a head, a part that comes again and again, an end.
HUGE = [
    ("net.json", b"", b"[", b""),
    ("net.json", b"[", b"0,", b"0]"),
    ("net.json", b"[", b"[],", b"0]"),
    ("net.json", b'{"a":[', b'{"b":0},', b"0]}"),
    ("net.json", b'{"format": "taut-net", "name": "', b"x", b'"}'),
    ("net.json", b'{"', b"x", b'": 1}'),
    ("net.json", b'{"format": "taut-net", "version": 1, "nodes": [[0,0,0]', b",[0,0,0]", b"]}"),
    ("result.json", b'{"format": "taut-identification", "edges": [', b'{"edge": 1},', b"0]}"),
    ("survey.csv", b"id,x,y,z\n", b",", b"\n"),
    ("survey.csv", b"id,x,y,z\n", b"5,1,1,1\n", b""),
    ("survey.csv", b"id,x,y,z\n5,", b"1", b",1,1\n"),
    ("survey.csv", b"", b"\n", b""),
    ("survey.csv", b"", b"\x00", b""),
    ("survey.csv", b"", b"(", b""),
    ("form.csv", b"id,x,y,z\n", b"5,1,1,1\n", b""),
    ("compas.json", b'{"node": {', b'"1":{"x":0},', b'"2":{}}}'),
    ("net.obj", b"", b"v 0 0 0\n", b""),
    ("net.obj", b"v 0 0 0\nl", b" 1", b"\n"),
    ("roof.ply", ROOF_HEAD, b"0 0 0\n", b""),
    ("landxml.xml", b"<LandXML>", b"<CgPoint>1 2 3</CgPoint>", b"</LandXML>"),
    ("landxml.xml", b"<LandXML>", b"<a>", b""),
    ("gsi8.gsi", b"", b"110001+00000005 81..00+00001000 82..00+00001000 83..00+00001000\n", b""),
    (
        "drawing.dxf",
        b"  0\nSECTION\n  2\nENTITIES\n",
        b"  0\nPOINT\n 10\n1.0\n 20\n1.0\n 30\n1.0\n",
        b"  0\nEOF\n",
    ),
    ("turned.csv", b"edge,stroke_mm\n", b"3,1\n", b""),
    ("offsets.csv", b"target,offset\n", b"5,1mm\n", b""),
]

#: Commands: words, the files that they read (which are changed), the files that they may write.
COMMANDS = [
    (["inspect", "net.json"], ["net.json"], []),
    (["inspect", "net.json", "--survey", "survey.csv"], ["net.json", "survey.csv"], []),
    (["form", "net.json", "-o", "out.csv", "--json"], ["net.json"], ["out.csv"]),
    (["form", "net.json", "--solver", "socp", "-o", "out.csv"], ["net.json"], ["out.csv"]),
    (["form", "net.json", "--turned", "turned.csv", "-o", "out.csv"], ["turned.csv", "net.json"], ["out.csv"]),
    (["form", "net.json", "--prior", "uniform:1mm", "--lengths", "lengths.csv"], ["net.json"], ["lengths.csv"]),
    (["sample", "net.json", "-n", "4", "-o", "out.h5", "--quiet"], ["net.json"], ["out.h5", "out.h5.partial"]),
    (["sample", "net.json", "-n", "4", "--uncertain", "loads:20N", "-o", "out.h5", "--quiet"], ["net.json"], ["out.h5", "out.h5.partial"]),
    (["train", "data.h5", "-o", "out.h5", "--quiet"], ["data.h5"], ["out.h5"]),
    (["identify", "net.json", "survey.csv", "--noise", "0.3mm", "-o", "out.json", "--quiet"], ["net.json", "survey.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--model", "model.h5", "-o", "out.json", "--draws", "0"], ["model.h5", "survey.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--forces", "forces.csv", "--noise", "0.3mm", "-o", "out.json", "--json"], ["forces.csv", "survey.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--control", "control.csv", "--noise", "0.3mm", "-o", "out.json", "--draws", "0"], ["control.csv", "survey.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--offsets", "offsets.csv", "--taut", "edges.txt", "--noise", "0.3mm", "-o", "out.json", "--draws", "0"], ["offsets.csv", "edges.txt"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--epoch", "second.csv:turned.csv", "--noise", "0.3mm", "-o", "out.json", "--draws", "0"], ["second.csv", "turned.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "polar.csv", "--noise", "0.3mm", "-o", "out.json", "--draws", "0"], ["polar.csv"], ["out.json", "out_draws.h5"]),
    (["identify", "net.json", "survey.csv", "--uncertain", "stiffness:5%", "--covariance-of", "edges.txt", "--noise", "estimate", "-o", "out.json", "--draws", "0"], ["edges.txt", "net.json"], ["out.json", "out_draws.h5"]),
    (["plan", "net.json", "result.json", "-o", "out.json", "--csv", "out.csv"], ["result.json", "net.json", "result_draws.h5"], ["out.json", "out.csv"]),
    (["plan", "net.json", "result.json", "-o", "out.json", "--target", "form.csv", "--node-weights", "weights.csv", "--stroke", "strokes.csv"], ["form.csv", "weights.csv", "strokes.csv"], ["out.json"]),
    (["plan", "net.json", "result.json", "-o", "out.json", "--target", "roof.ply", "--check", "loads.csv", "--adjustable", "edges.txt"], ["roof.ply", "loads.csv", "edges.txt"], ["out.json"]),
    (["report", "result.json", "-o", "out.html"], ["result.json"], ["out.html"]),
    (["report", "plan.json", "-o", "out.html"], ["plan.json"], ["out.html"]),
    (["report", "study.json", "-o", "out.html"], ["study.json"], ["out.html"]),
    (["report", "comparison.json", "-o", "out.html"], ["comparison.json"], ["out.html"]),
    (["report", "jobs.json", "-o", "out.html"], ["jobs.json"], ["out.html"]),
    (["export", "net.json", "form.csv", "--to", "obj", "-o", "out.obj"], ["net.json", "form.csv"], ["out.obj"]),
    (["export", "net.json", "--to", "compas", "-o", "out.json"], ["net.json"], ["out.json"]),
    (["export", "net.json", "form.csv", "--to", "vtk", "-o", "out.vtk"], ["form.csv"], ["out.vtk"]),
    (["export", "result.json", "--to", "net", "-o", "out.json"], ["result.json"], ["out.json"]),
    (["export", "result.json", "--to", "xlsx", "-o", "out.xlsx"], ["result.json"], ["out.xlsx"]),
    (["export", "plan.json", "--to", "xlsx", "-o", "turns.xlsx"], ["plan.json"], ["turns.xlsx"]),
    (["import", "compas.json", "-o", "out.json", "--axial-stiffness", "100kN"], ["compas.json"], ["out.json"]),
    (["import", "compas.json", "-o", "out.json", "--stress-strain", "strands.csv", "--diameter", "8mm"], ["strands.csv", "compas.json"], ["out.json"]),
    (["import", "nodes.csv", "--edges", "nodes_edges.csv", "-o", "out.json"], ["nodes.csv", "nodes_edges.csv"], ["out.json"]),
    (["import", "net.obj", "-o", "out.json", "--supports", "boundary", "--axial-stiffness", "100kN"], ["net.obj"], ["out.json"]),
    (["import", "ridge_compas.json", "-o", "out.json"], ["ridge_compas.json"], ["out.json"]),
    (["import", "ridge.csv", "--edges", "ridge_edges.csv", "-o", "out.json"], ["ridge.csv", "ridge_edges.csv"], ["out.json"]),
    (["frame", "net.json", "frame.csv", "-o", "out.json"], ["frame.csv", "net.json"], ["out.json"]),
    (["identify", "framed.json", "survey.csv", "--noise", "0.3mm", "-o", "out.json", "--draws", "0"], ["framed.json"], ["out.json", "out_draws.h5"]),
    (["survey", "net.json", "form.csv", "--noise", "0.2mm", "-o", "out.csv"], ["net.json", "form.csv"], ["out.csv"]),
    (["control", "net.json", "-o", "study", "--trials", "1", "--rounds", "1", "--draws", "10", "--quiet"], ["net.json"], ["study/"]),
    (["compare", "net.json", "-o", "study", "--noise", "0.3mm", "--training", "10", "--surveys", "1", "--quiet"], ["net.json"], ["study/"]),
    (["reproduce", "--net", "net.json", "--samples", "12", "--validation", "2", "-o", "study", "--quiet"], ["net.json"], ["study/"]),
    *((["inspect", "net45.json", "--survey", name], [name], []) for name in (
        "drawing.dxf", "english.txt", "excel.xlsx", "gama.xml", "german.csv", "gsi16.gsi", "gsi8.gsi", "jobxml.jxl", "landxml.xml", "scan.pts", "scan.xyz",
    )),
]  # fmt: skip

#: Words that are put in the place of others, or at the end.
WORDS = [
    "", "-", "--", "-o", "--noise", "nanmm", "1e308m", "-1mm", "--prior", "uniform:1e9mm",
    "--threads", "--memory", "300MiB", "0", "99999999999", "--seed", "-1", "2^3", "--json",
    "--quiet", "/dev/null", "/dev/full", ".", "..", "nowhere/out", "\x1b[31m", "a" * 3000,
    "--frame", "net", "--unit", "mm", "--help", "--version",
]  # fmt: skip


def changed_words(rng: random.Random, words: list[str]) -> list[str]:
    """A command line that somebody mistyped."""
    words = list(words)
    for _ in range(rng.choice([1, 1, 2])):
        if rng.random() < 0.5:
            words[rng.randrange(len(words))] = rng.choice(WORDS)
        else:
            words.insert(rng.randrange(1, len(words) + 1), rng.choice(WORDS))
    return words
