#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Fills the tables of docs/methods.md anew with what the program at build/taut prints: some minutes.
# Usage: scripts/update_methods.sh [OPTION OF taut compare]...
set -euo pipefail
cd "$(dirname "$0")/.."
folder=build/methods
mkdir -p "$folder"
export PATH="$PWD/build:$PATH"

# Puts a command and its output into the block of that name.
fill() {
    local name=$1
    shift
    (cd "$folder" && "$@") > "$folder/$name.txt"
    {
        printf '```\n$ %s\n' "$*"
        sed -e '/^written to/,$d' -e 's/ *$//' "$folder/$name.txt" | sed -e '${/^$/d}'
        echo '```'
    } | python3 benchmarks/page_block.py methods.md "scripts/update_methods.sh: $name"
}

taut example hilo-quarter -o "$folder/net.json" > /dev/null
fill uniform taut compare net.json -o uniform "$@"
# The standard deviation of the uniform prior of 5 mm.
fill normal taut compare net.json -o normal --prior normal:2.9mm --noise 0,0.1mm,0.5mm,2mm \
    --training 950 --hidden 0 "$@"
fill model_errors taut compare net.json -o model_errors --noise 0.5mm --training 950 --hidden 0 \
    --uncertain supports:1mm --uncertain stiffness:3% --uncertain loads:20N --uncertain adjustable:0.5mm "$@"
