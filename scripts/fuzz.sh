#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Feeds each reader files that are damaged in ways it has not met yet, starting from our own examples,
# from the fewest files that reach all that earlier runs reached (tests/fuzz/corpus), from what was
# found before (tests/fuzz/found) and from the small files of other people, where they are there.
# Fails when a reader crashes, hangs or throws what it should not; the file that made it do so is then
# named. With --keep what it has reached goes into tests/fuzz/corpus, for later runs to go on from.
# Usage: scripts/fuzz.sh [--keep] SECONDS_PER_READER [READER]...
set -euo pipefail
cd "$(dirname "$0")/.."

keep=
if [[ "${1:-}" == --keep ]]; then
    keep=yes
    shift
fi
seconds=${1:?seconds per reader}
readers=("${@:2}")
((${#readers[@]} > 0)) || readers=(net compas csv_net csv_survey foreign_survey obj surface_mesh model xlsx)

# The libraries that the tests under the sanitizers have, too; the first files come from the release's program.
build=build/asan
taut=build/taut
if [[ ! -x $taut ]]; then
    echo "fuzz.sh: there is no $taut, which writes the first files: run 'make build'" >&2
    exit 1
fi
cmake --log-level=WARNING --preset asan
cmake --build --preset asan --target "${readers[@]/#/fuzz_}"

real=${TAUT_REAL_DATA:-../shared/data}
seeds=$build/fuzz/seeds
kept=tests/fuzz/corpus
# What HDF5 and oneTBB keep until the end is no leak of ours.
export ASAN_OPTIONS=detect_leaks=0

make_seeds() {
    local reader
    rm -rf $seeds
    for reader in "${readers[@]}"; do
        mkdir -p $seeds/"$reader" $build/fuzz/corpus/"$reader"
        [[ ! -f $kept/$reader.tar.xz ]] || tar -xJf $kept/"$reader".tar.xz -C $seeds/"$reader"
    done
    local work=$seeds/work
    mkdir -p $work
    $taut example hypar:2x3 -o $work/net.json >/dev/null
    $taut export $work/net.json --to compas -o $work/graph.json >/dev/null
    $taut export $work/net.json --to obj -o $work/net.obj >/dev/null
    $taut export $work/net.json --to csv -o $work/net.csv >/dev/null
    $taut form $work/net.json -o $work/form.csv >/dev/null
    $taut sample $work/net.json -n 8 -o $work/data.h5 --quiet >/dev/null
    $taut train $work/data.h5 -o $work/model.h5 --quiet >/dev/null
    echo "----" >$work/between

    copy net $work/net.json
    copy compas $work/graph.json
    copy obj $work/net.obj
    printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >$work/roof.ply
    copy surface_mesh $work/roof.ply
    copy csv_survey $work/form.csv
    copy model $work/model.h5
    local survey
    for survey in tests/data/surveys/*; do
        [[ $survey == *.py ]] || copy foreign_survey "$survey"
    done
    copy xlsx tests/data/surveys/excel.xlsx
    python3 -c 'import sys, zipfile
for part in (file := zipfile.ZipFile(sys.argv[1])).namelist():
    print("--- " + part, file.read(part).decode(), sep="\n")' tests/data/surveys/excel.xlsx >$work/excel.parts
    copy xlsx $work/excel.parts
    cat $work/net.csv $work/between $work/net_edges.csv >$work/pair.csv
    copy csv_net $work/pair.csv
    # What is kept holds nothing of other people's.
    while [[ -z "$keep" ]] && IFS= read -r -d '' file; do
        copy compas "$file"
    done < <(find "$real" -name '*.json' -size -64k -print0 2>/dev/null)
}

copy() { # reader file
    [[ ! -d $seeds/$1 ]] || cp "$2" $seeds/"$1"/
}

# Says nothing until it ends, since others run beside it. With a fixed seed, so that a run is all but
# repeatable; the corpus that it leaves makes the next one go on from there.
fuzz() { # reader
    local reader=$1 found=tests/fuzz/found/$1 log=$build/fuzz/$1.log
    [[ -d $found ]] || found=
    # A file that takes longer than 10 s, or more than 1 GiB, counts as found.
    # shellcheck disable=SC2086
    if "$build/tests/fuzz/fuzz_$reader" "$build/fuzz/corpus/$reader" "$seeds/$reader" $found \
        -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len=65536 \
        -seed=1 -print_final_stats=1 -verbosity=0 -artifact_prefix="$build/fuzz/$reader-" 2>"$log"; then
        echo "fuzz: $reader: $(grep -oE "number_of_executed_units: *[0-9]+" "$log")"
        return 0
    fi
    echo "fuzz: $reader: FAILED, all of it in $log" >&2
    grep -E "ERROR|SUMMARY|Test unit written|what\(\)" "$log" >&2 || tail -n 20 "$log" >&2
    return 1
}

# The fewest files that reach what corpus and seeds reach. The same files give the same archive.
keep_corpus() { # reader
    local merged=$build/fuzz/merged/$1
    rm -rf "$merged"
    mkdir -p "$merged" $kept
    "$build/tests/fuzz/fuzz_$1" -merge=1 -timeout=10 -rss_limit_mb=1024 -max_len=65536 -verbosity=0 \
        "$merged" "$seeds/$1" "$build/fuzz/corpus/$1" 2>/dev/null
    tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -cJf $kept/"$1".tar.xz -C "$merged" .
    echo "fuzz: $1: $(find "$merged" -type f | wc -l) files kept"
}

make_seeds
export -f fuzz
export build seeds seconds
# A reader a core.
printf '%s\n' "${readers[@]}" | xargs --max-args=1 --max-procs="$(nproc)" bash -c 'fuzz "$0"'
if [[ -n "$keep" ]]; then
    for reader in "${readers[@]}"; do
        keep_corpus "$reader"
    done
fi
