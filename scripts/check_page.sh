#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Runs the commands of a page of docs/: each ```sh block, in order, in one temporary folder, with
# build/taut on the PATH, and each line `<!-- run: COMMAND -->`, which the page does not show. A block
# below the line `<!-- not run -->` is left out, and so are its lines that start with make or git: those
# need the checkout and are run elsewhere. A page with $TAUT_REAL_DATA, other people's files, is left out
# where these are not there.
# Usage: scripts/check_page.sh FILE
set -euo pipefail
page=$(realpath "$1")
cd "$(dirname "$0")/.."
export PATH="$PWD/build:$PATH"
export TAUT_REAL_DATA="${TAUT_REAL_DATA:-$PWD/../shared/data}"
if [[ ! -d $TAUT_REAL_DATA ]] && grep --quiet --fixed-strings '$TAUT_REAL_DATA' "$page"; then
    echo "check_page.sh: left out: $TAUT_REAL_DATA is not there (TAUT_REAL_DATA)"
    exit 0
fi
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
    !inside && sub(/^<!-- run: /, "") && sub(/ -->[[:space:]]*$/, "") {
        print "# line " NR "\n" $0 > sprintf("%s/%03d", folder, ++count)
        next
    }
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
