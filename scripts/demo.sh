#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# The paper's experiment on the built-in net, then one job on a simulated site: survey, lengths,
# turns. Ends in two reports in a folder, build/demo if none is told.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
folder=${1:-build/demo}

taut() {
    echo
    echo "taut $*"
    "$root/build/taut" "$@"
}

build/taut reproduce -o "$folder"
cd "$folder"
taut example hilo-quarter -o net.json
taut form net.json --law uniform:5mm --seed 3 -o built.csv
taut survey net.json built.csv --noise 0.5mm --drop 10% -o survey.csv
taut identify net.json survey.csv -o result.json
taut plan net.json result.json -o plan.json --csv turns.csv --tension 1.5kN..10kN --turn 5mm --step 1/4 --crews 2 \
    --thread right
taut report plan.json -o plan.html
echo
echo "$folder/report.html: the paper's experiment; $folder/plan.html: what to turn, with the list for the crews"
