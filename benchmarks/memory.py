# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The largest memory that each command takes, over nodes, edges and samples, as JSON.

Usage: memory.py TAUT OUTPUT.json
"""

import json
import os
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])
OUTPUT = os.path.abspath(sys.argv[2])


def peak(*arguments):
    """Largest resident memory of one run [bytes]."""
    process = subprocess.Popen(
        [PROGRAM, *arguments, "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"taut {' '.join(arguments)}: {process.stderr.read().decode()}")
    return 1024 * usage.ru_maxrss


def of_nets(sides):
    """The commands that grow with the net."""
    for side in sides:
        net = f"hypar{side}.json"
        # Of each command, what it takes and what the next one reads.
        commands = [
            ("example", f"hypar:{side}x{side}", "-o", net),
            ("inspect", net),
            ("form", net, "--prior", "uniform:5mm", "-o", "site.csv"),
            ("survey", net, "site.csv", "--noise", "0.5mm", "-o", "survey.csv"),
            ("identify", net, "survey.csv", "-o", "result.json"),
            ("export", "result.json", "--to", "csv", "-o", "tables"),
            ("plan", net, "result.json", "-o", "plan.json"),
            ("report", "result.json", "-o", "report.html"),
        ]
        for command in commands:
            yield {"command": command[0], "net": f"hypar:{side}x{side}", "bytes": peak(*command)}


def of_samples(counts):
    """The commands that grow with samples, on the built-in net."""
    peak("example", "hilo-quarter", "-o", "net.json")
    peak("form", "net.json", "--prior", "uniform:5mm", "-o", "form.csv")
    peak("survey", "net.json", "form.csv", "--noise", "0.5mm", "-o", "survey.csv")
    for count in counts:
        commands = [
            ("sample", "net.json", "-n", str(count), "-o", "data.h5"),
            ("train", "data.h5", "-o", "model.h5"),
            ("identify", "net.json", "survey.csv", "--model", "model.h5", "-o", "gp.json"),
        ]
        for command in commands:
            yield {
                "command": command[0],
                "samples": count,
                "bytes": peak(*command),
                "data_set_bytes": os.path.getsize("data.h5"),
            }


def of_studies():
    """The studies, on the built-in net, with the settings that they have by default."""
    for command in [
        ("reproduce", "-o", "study"),
        ("compare", "net.json", "-o", "comparison", "--surveys", "5"),
        ("control", "net.json", "-o", "control", "--tension", "1.5kN..10kN", "--trials", "2"),
    ]:
        yield {"command": command[0], "bytes": peak(*command)}


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    measured = {
        "nets": list(of_nets([30, 100])),
        "samples": list(of_samples([1000, 3000, 10000])),
        "studies": list(of_studies()),
    }
with open(OUTPUT, "w", encoding="utf-8") as file:
    json.dump(measured, file, indent=1)
