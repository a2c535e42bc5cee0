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
page=$(<docs/methods.md)

# Puts the command NET... and its output between the markers of a table.
fill() {
    local name=$1
    shift
    (cd "$folder" && "$@") > "$folder/$name.txt"
    page=$(NAME=$name COMMAND="$*" TEXT=$folder/$name.txt python3 -c '
import os, pathlib, re, sys
page = sys.stdin.read()
text = "\n".join(line.rstrip() for line in pathlib.Path(os.environ["TEXT"]).read_text().splitlines())
block = "<!-- {} -->\n```\n$ {}\n{}\n```\n<!-- end -->".format(
    os.environ["NAME"], os.environ["COMMAND"], text.split("\nwritten to")[0].rstrip())
found = r"<!-- " + os.environ["NAME"] + r" -->\n.*?<!-- end -->"
page, count = re.subn(found, lambda _: block, page, flags=re.S)
sys.exit(f"docs/methods.md has {count} places") if count != 1 else print(page, end="")
' <<< "$page")
}

taut example hilo-quarter -o "$folder/net.json" > /dev/null
fill uniform taut compare net.json -o uniform "$@"
# The standard deviation of the uniform law of 5 mm.
fill normal taut compare net.json -o normal --prior normal:2.9mm --noise 0,0.1mm,0.5mm,2mm \
    --training 950 --hidden 0 "$@"
fill model_errors taut compare net.json -o model_errors --noise 0.5mm --training 950 --hidden 0 \
    --unknown supports:1mm --unknown stiffness:3% --unknown loads:20N --unknown adjustable:0.5mm "$@"
printf '%s\n' "$page" > docs/methods.md
