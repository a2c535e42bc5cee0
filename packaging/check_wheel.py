# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What an installed wheel must do on any system: identify and plan, from Python and by the program."""

import subprocess
import tempfile
from pathlib import Path

import taut

net = taut.hilo_quarter()
built = taut.built_net(net, prior="uniform:5mm", seed=7)
form = taut.solve_equilibrium(built).form
measured = taut.simulate_survey(net, form, noise="0.5mm", seed=3)
found = taut.identify(net, taut.read_survey(net, measured))
plan = taut.plan(found)
print(f"taut {taut.__version__}: {found.trust}, {len(plan.strokes)} strokes")
assert found.trust == "passed", found.message

with tempfile.TemporaryDirectory() as temporary:
    name = Path(temporary, "r\u00e9sultat")  # names are not ASCII alone
    name.mkdir()
    for line in (
        "example hilo-quarter -o net.json",
        "form net.json --prior uniform:5mm --seed 7 -o form.csv",
        "survey net.json form.csv --noise 0.5mm --seed 3 -o survey.csv",
        "identify net.json survey.csv --noise 0.5mm -o result.json",
        "plan net.json result.json -o plan.json --csv turns.csv",
        "report result.json -o report.html",
        "export result.json --to xlsx -o result.xlsx",
        "sample net.json --samples 100 -o samples.h5",
        "train samples.h5 -o model.h5",
    ):
        subprocess.run(["taut", *line.split()], cwd=name, check=True, stdout=subprocess.DEVNULL)
    print("program:", ", ".join(sorted(file.name for file in name.iterdir())))
