#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Runs the program on hostile input, in hostile surroundings, and holds it to its contract.

What was found once is run again first: seeds.json holds it. Needs NumPy; strace and a C compiler for
faults, root for those of another user's rights.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

import page_block
from areas import AREAS
from faults import can_inject, every_fault, faults
from sandbox import Finding, Sandbox

SEEDS = Path(__file__).parent / "seeds.json"
FOREIGN = Path(__file__).parents[1] / "data" / "surveys"


ROOF = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0.1
4 0 0.2
4 4 0.1
0 4 0.2
4 0 1 2 3
"""


def make_originals(sandbox: Sandbox, folder: Path):
    """An example of each input: what the program makes of a small net, and tables by hand."""

    def do(words: str):
        run = sandbox.run(*words.split(), "--quiet")
        if run.code != 0:
            raise SystemExit(f"hostile: an example cannot be made: {run}")

    folder.mkdir()
    do("example hypar:4x4 -o net.json")
    do("form net.json -o form.csv")
    do("form net.json --prior uniform:1mm -o built.csv")
    do("survey net.json built.csv --noise 0.3mm -o survey.csv")
    do("survey net.json built.csv --noise 0.3mm --seed 2 -o second.csv")
    do("survey net.json built.csv --station 1,-3,1 --station -2,2,1 -o polar.csv")
    do("sample net.json -n 30 -o data.h5")
    do("train data.h5 -o model.h5")
    do("identify net.json survey.csv --noise 0.3mm --prior uniform:1mm -o result.json")
    do("plan net.json result.json --csv turns.csv --turn 5mm -o plan.json")
    do("reproduce --net net.json --samples 12 --validation 2 -o study")
    do("compare net.json -o compared --noise 0.3mm --training 10 --surveys 2")
    do("control net.json -o jobs --trials 2 --rounds 1 --draws 20")
    do("export net.json --to compas -o compas.json")
    do("export net.json --to csv -o nodes.csv")
    do("export net.json --to obj -o net.obj")
    do("example hypar:2x2 -o tiny.json")
    do("export tiny.json --to compas -o tiny_compas.json")
    net = json.loads(sandbox.read("net.json"))
    rows = sandbox.read("form.csv").decode().splitlines()
    edge = net["adjustable"][0]
    node = next(n for n in range(len(net["nodes"])) if n not in net["supports"])
    for name, text in {
        "turned.csv": f"edge,stroke_mm\n{edge},2.5\n",
        "forces.csv": f"edge,tension,std\n{edge},4000,50\n",
        "control.csv": "\n".join([rows[0], *(rows[1 + n] for n in net["supports"])]) + "\n",
        "offsets.csv": f"target,offset,std\n{node},3mm,0.2mm\n",
        "weights.csv": f"id,normal,tangential\n{node},2,0.1\n",
        "strokes.csv": f"edge,shortest,longest\n{edge},-0.02,0.02\n",
        "loads.csv": f"id,x,y,z\n{node},0,0,-100\n",
        "edges.txt": f"{edge}\n{net['adjustable'][1]}\n",
        "strands.csv": "strain,stress\n0,0\n0.0022,110e6\n0.00286,110e6\n0.02,1352.65e6\n",
        "roof.ply": ROOF,
        "frame.csv": frame(net["supports"][:2]),
    }.items():
        sandbox.write(name, text)
    do("frame net.json frame.csv -o framed.json")
    do("example sliding-ridge -o ridge.json")
    do("export ridge.json --to compas -o ridge_compas.json")
    do("export ridge.json --to csv -o ridge.csv")
    for path in sandbox.folder.iterdir():
        if path.is_file():
            (folder / path.name).write_bytes(path.read_bytes())
    for folder_name, file, name in (("study", "results", "study"), ("compared", "comparison", "comparison"), ("jobs", "control", "jobs")):  # fmt: skip
        (folder / f"{name}.json").write_bytes(sandbox.read(f"{folder_name}/{file}.json"))
    # The net that the surveys of other programs in tests/data are of.
    do("example hypar:4x5 -o net45.json")
    (folder / "net45.json").write_bytes(sandbox.read("net45.json"))
    for path in FOREIGN.iterdir():
        if path.suffix != ".py" and "worst" not in path.name:
            (folder / path.name).write_bytes(path.read_bytes())


def frame(supports: list[int]) -> str:
    """The stiffness of a frame of two supports, as frame.csv."""
    entries = [(f"{node}.{axis}", f"{node}.{axis}", 1e6) for node in supports for axis in "xyz"]
    entries.append((f"{supports[0]}.z", f"{supports[1]}.z", -3e5))
    return "row,column,stiffness\n" + "".join(f"{a},{b},{k}\n" for a, b, k in entries)


def write_page(what: str, rows: list[tuple[str, int, int, int]]):
    """Puts the counts into docs/reliability.md."""
    lines = ["| area | cases | runs | found |", "|---|---|---|---|"]
    lines += [f"| {name} | {cases} | {runs} | {bad} |" for name, cases, runs, bad in rows]
    head = f"On {time.strftime('%Y-%m-%d')}, {what}:\n\n"
    page_block.put("reliability.md", "tests/hostile/run.py", head + "\n".join(lines))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    option = parser.add_argument
    option("--program", type=Path, required=True)
    option("--seconds", type=float, default=60.0, help="after the seeds that were found before")
    option("--seed", type=int, default=None, help="of the first case (default: by the clock)")
    option("--area", action="append", choices=[*AREAS, "faults"], help="one; may be given again")
    option("--without", action="append", default=[], choices=AREAS, help="not this area")
    option("--cases", type=int, default=None, help="at most so many of each area")
    option("--every-fault", action="store_true", help="each call of the system fails in turn, too")
    option("--write", action="store_true", help="put the counts into docs/reliability.md")
    option("--keep", action="store_true", help="add what is found to seeds.json")
    arguments = parser.parse_args()
    areas = {**AREAS, "faults": faults}
    chosen = [area for area in arguments.area or areas if area not in arguments.without]
    if why := can_inject():
        print(f"hostile: no faults: {why}")
        chosen = [area for area in chosen if area != "faults"]
    program = arguments.program.resolve()
    first = arguments.seed if arguments.seed is not None else time.time_ns() % 10**9
    print(f"hostile: seed {first}, {', '.join(chosen)}")
    found: list[tuple[str, int, str]] = []
    with tempfile.TemporaryDirectory() as scratch:
        os.chmod(scratch, 0o755)
        work = Path(scratch) / "work"
        work.mkdir()
        sandbox = Sandbox(program, work)
        originals = Path(scratch) / "originals"
        make_originals(sandbox, originals)

        def case(area: str, seed: int):
            try:
                areas[area](random.Random(f"{area} {seed}"), sandbox, originals)
            except Finding as finding:
                found.append((area, seed, str(finding)))
                print(f"hostile: found: {area} {seed}: {str(finding)[:600]}", flush=True)

        counts = dict.fromkeys(chosen, 0)
        for area, seed in json.loads(SEEDS.read_text()) if SEEDS.exists() else []:
            if area in chosen:
                case(area, seed)
                counts[area] += 1
        runs_of = dict.fromkeys(chosen, 0)
        end = time.monotonic() + arguments.seconds
        seed = first
        while time.monotonic() < end:
            if arguments.cases is not None and seed - first >= arguments.cases:
                break
            for area in chosen:
                before = sandbox.runs
                case(area, seed)
                counts[area] += 1
                runs_of[area] += sandbox.runs - before
                if time.monotonic() >= end:
                    break
            seed += 1
        rows = []
        for area in chosen:
            bad = sum(1 for one in found if one[0] == area)
            print(f"hostile: {area}: {counts[area]} cases, {runs_of[area]} runs, {bad} found")
            rows.append((f"`{area}`", counts[area], runs_of[area], bad))
        what = f"seed {first}, {arguments.seconds:.0f} s"
        if arguments.write:
            write_page(what, rows)
        if arguments.every_fault and not can_inject():
            for kind, (done, broken) in every_fault(sandbox, originals).items():
                for one in broken:
                    print(f"hostile: found: {one[:600]}")
                print(
                    f"hostile: {kind} failed in turn: {done} runs, {len(broken)} found", flush=True
                )
                rows.append((f"{kind}, in turn", done, done, len(broken)))
                found.extend(("every fault", 0, one) for one in broken)
            if arguments.write:
                write_page(what, rows)
        print(f"hostile: {sandbox.runs} runs, {len(found)} found")
    if arguments.keep:
        known = json.loads(SEEDS.read_text()) if SEEDS.exists() else []
        known += [
            [area, seed] for area, seed, _ in found if area in areas and [area, seed] not in known
        ]
        SEEDS.write_text(json.dumps(known) + "\n")
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
