# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Measures the page of `make app` beside the program.

Usage: /usr/bin/python3 benchmarks/app.py [--write]
"""

import json
import pathlib
import subprocess

from page_block import heading, show

APP = pathlib.Path("build/app")
LARGE = "hypar:45x45"


def measured(script, *arguments):
    command = ["node", f"viewer/tests/{script}", *arguments]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def lines():
    speed = measured("app_speed.mjs", APP / "taut.html", "build/taut")
    memory = measured("app_memory.mjs", APP / "taut.wasm", LARGE)
    yield from heading("work | in the page | by the program, one thread")
    yield f"| until the page is ready | {speed['ready']:.2f} s | |"
    for name, work in (("identify", "identify, 200 posterior samples"), ("plan", "plan, over these samples")):
        times = speed[name]
        yield f"| {work} | {times['app']:.2f} s | {times['program']:.2f} s |"
    for name, work in (("identify", "identify"), ("plan", "plan")):
        row = memory[name]
        yield f"| {work}, `{LARGE}` | {row['seconds']:.0f} s, {row['mebibytes']:.0f} MiB | |"


if __name__ == "__main__":
    show("performance.md", __file__, lines())
