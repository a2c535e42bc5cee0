#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# The paper's experiment on the built-in net, then one job on a simulated site: survey, lengths,
# turns. Ends in two reports in a folder, build/demo if none is given.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
folder=${1:-build/demo}

taut() {
    echo
    echo "taut $*"
    "$root/build/taut" "$@"
}

# What this build can do only with cargo (plans) or Node.js (reports): named, and left out.
taut_if_built() {
    local output
    if output=$(taut "$@" 2>&1); then
        echo "$output"
    elif [[ "$output" == *"built without"* ]]; then
        echo "$output"
        echo "left out: see scripts/install_dependencies.sh for what is optional"
        return 1
    else
        echo "$output" >&2
        exit 1
    fi
}

build/taut reproduce -o "$folder"
cd "$folder"
taut example hilo-quarter -o net.json
taut form net.json --prior uniform:5mm --seed 3 -o built.csv
taut survey net.json built.csv --noise 0.5mm --drop 10% -o survey.csv
taut identify net.json survey.csv -o result.json
made="$folder: the paper's experiment"
[[ -f report.html ]] && made="$folder/report.html: the paper's experiment"
if taut_if_built plan net.json result.json -o plan.json --csv turns.csv --tension 1.5kN..10kN --turn 5mm --step 1/4 \
    --crews 2 --thread right; then
    made+="; $folder/turns.csv: what to turn"
    if taut_if_built report plan.json -o plan.html; then
        made+="; $folder/plan.html: the same with the list for the crews"
    fi
fi
echo
echo "$made"
