#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Runs the program of scripts/windows.sh with Wine, which is not Windows, in a folder whose name is not ASCII, and
# compares what it finds and plans with what build/taut does. Where there is a wheel for Python 3.12, that identifies
# and plans in a Python for Windows, too.
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
    "$where" sample "Ł.json" --samples 100 -o "Ł.h5"
    "$where" train "Ł.h5" -o model.h5
    "$where" identify "Ł.json" survey.csv --noise 0.5mm --method gp --model model.h5 -o by_model.json
    "$where" plan "Ł.json" result.json -o plan.json --csv turns.csv  # over the files of before
    # What is wrong is one line, and leaves no file.
    status=0
    "$where" identify "Ł.json" "none Ł.csv" -o none.json 2>said || status=$?
    if [[ "$status" != 2 || "$(cat said)" != *"none Ł.csv: cannot be read"* || -e none.json ]]; then
        echo "check_windows.sh: $where: exit code $status: $(cat said)" >&2
        exit 1
    fi
done >"$folder/said"
diff <(ls "$folder/here") <(ls "$folder/there")
python3 - "$folder" <<'PYTHON'
import json
import sys


def values(value):
    if isinstance(value, dict):
        return [v for part in value.values() for v in values(part)]
    return [v for part in value for v in values(part)] if isinstance(value, list) else [value]


def difference(name, a, b):
    if isinstance(a, float) and isinstance(b, float):
        return abs(a - b) / max(abs(a), abs(b), 1e-6)
    assert a == b, f"{name}: {a} here, {b} there"
    return 0.0


def read(where, name):
    document = json.load(open(f"{sys.argv[1]}/{where}/{name}", encoding="utf-8"))
    document.pop("date", None)
    if "draws" in document and name == "result.json":
        del document["draws"]["fingerprint"]  # of the last bits
    return values(document)


for name in ("Ł.json", "result.json", "plan.json", "by_model.json"):
    here, there = read("here", name), read("there", name)
    assert len(here) == len(there), f"{name}: {len(here)} and {len(there)} values"
    largest = max(map(difference, [name] * len(here), here, there))
    print(f"{name}: {len(here)} values, the largest relative difference of a number {largest:.1e}")
    assert largest < 1e-3, name
PYTHON

wheels=("$root"/build/windows/wheels/*-cp312-abi3-*.whl)
if [[ ! -e "${wheels[0]}" ]]; then
    echo "check_windows.sh: no wheel for Python 3.12 and later: no wheel was tried"
    exit 0
fi
python="$root/build/windows/python"
rm -rf "$python"
install=("$root/build/venv/uv/bin/uv" pip install --quiet --python-version 3.12 --python-platform x86_64-pc-windows-msvc
    --no-deps --target "$python")
"${install[@]}" --require-hashes -r "$root/scripts/requirements/windows.txt"
"${install[@]}" "${wheels[0]}"
printf 'python312.zip\n.\n' >"$python/python312._pth"
# Wine hands Python no streams but pipes.
WINEPATH="$(wine winepath -w "$python/taut")" wine "$python/python.exe" "$(wine winepath -w "$root/packaging/check_wheel.py")" \
    </dev/null 2>&1 | cat
