#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Runs the program of scripts/windows.sh with Wine, which is not Windows, in a folder whose name is not ASCII, and
# compares what it finds and plans with what build/taut does.
# Usage: scripts/check_windows.sh
set -euo pipefail
cd "$(dirname "$0")/.."
root="$PWD"
export LC_ALL=C.UTF-8 WINEPREFIX="$root/build/windows/wine" WINEDEBUG=-all
folder="$root/build/windows/résultat Łódź"
rm -rf "$folder"
mkdir -p "$folder"/{here,there}

there() { wine "$root/build/windows/taut/taut.exe" "$@"; }
here() { "$root/build/taut" "$@"; }

for where in here there; do
    cd "$folder/$where"
    "$where" example hilo-quarter -o "Ł.json"
    "$where" form "Ł.json" --prior uniform:5mm --seed 7 -o form.csv
    "$where" survey "Ł.json" form.csv --noise 0.5mm --seed 3 -o survey.csv
    "$where" identify "Ł.json" survey.csv --noise 0.5mm -o result.json
    "$where" plan "Ł.json" result.json -o plan.json --csv turns.csv
    "$where" report result.json -o report.html
    "$where" export result.json --to xlsx -o result.xlsx
    "$where" sample "Ł.json" --samples 100 -o samples.h5
    "$where" train samples.h5 -o model.h5
    "$where" identify "Ł.json" survey.csv --noise 0.5mm --method gp --model model.h5 -o by_model.json
    # What is wrong is one line, and leaves no file.
    status=0
    "$where" identify "Ł.json" "none Ł.csv" -o none.json 2>said || status=$?
    [[ "$status" == 2 && "$(cat said)" == *"none Ł.csv: cannot be read"* && ! -e none.json ]]
done >"$folder/said"
diff <(ls "$folder/here") <(ls "$folder/there")
python3 - "$folder" <<'PYTHON'
import json
import math
import sys


def numbers(value):
    if isinstance(value, dict):
        return [n for key, part in value.items() if key not in ("run", "version") for n in numbers(part)]
    if isinstance(value, list):
        return [n for part in value for n in numbers(part)]
    return [value] if isinstance(value, float) else []


for name in ("Ł.json", "result.json", "plan.json", "by_model.json"):
    here, there = (numbers(json.load(open(f"{sys.argv[1]}/{where}/{name}", encoding="utf-8"))) for where in ("here", "there"))
    assert len(here) == len(there), f"{name}: {len(here)} and {len(there)} numbers"
    largest = max(abs(a - b) / max(abs(a), abs(b), 1e-3) for a, b in zip(here, there))
    print(f"{name}: {len(here)} numbers, the largest relative difference {largest:.1e}")
    assert largest < 1e-3, name
PYTHON
