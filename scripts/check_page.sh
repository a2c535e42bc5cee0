#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Runs the commands of a page of docs/: each ```sh block, in order, in one temporary folder, with
# build/taut on the PATH. A block below the line `<!-- not run -->` is left out, and so are its
# lines that start with make or git: those need the checkout and are run elsewhere.
# Usage: scripts/check_page.sh FILE
set -euo pipefail
page=$(realpath "$1")
cd "$(dirname "$0")/.."
export PATH="$PWD/build:$PATH"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Writes block N, which opens in line L of the page, to blocks/N, led by a comment with L.
mkdir "$folder/blocks" "$folder/run"
awk -v folder="$folder/blocks" '
    /^```sh[[:space:]]*$/ && !inside {
        inside = 1
        file = skip ? "" : sprintf("%s/%03d", folder, ++count)
        if (file) print "# line " NR > file
        next
    }
    /^```/ { inside = 0; skip = 0; next }
    inside && file && !/^(make|git)([[:space:]]|$)/ { print > file }
    !inside && NF { skip = /^<!-- not run -->[[:space:]]*$/ }
' "$page"

ln -s "$PWD/tests" "$folder/run/tests"  # example files are named as from the checkout
cd "$folder/run"
count=0
for block in "$folder"/blocks/*; do
    [[ -e $block ]] || break
    [[ $(wc -l < "$block") -gt 1 ]] || continue
    cat "$block"
    if ! bash -euo pipefail "$block" </dev/null; then
        echo "check_page.sh: failed: the block at $(head -n 1 "$block" | cut -c 3-)" >&2
        exit 1
    fi
    count=$((count + 1))
done
if ((count == 0)); then
    echo "check_page.sh: $page shows no command to run" >&2
    exit 1
fi
echo "check_page.sh: $count blocks ran"
