#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Feeds each reader files that are damaged in ways it has not met yet, starting from our own examples,
# from what was found before (tests/fuzz/found) and from the small files of other people, where they
# are there. Fails when a reader crashes, hangs or throws what it should not; the file that made it
# do so is then named.
# Usage: scripts/fuzz.sh SECONDS_PER_READER [READER]...
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:?seconds per reader}
readers=("${@:2}")
((${#readers[@]} > 0)) || readers=(net compas csv_net csv_survey obj model)

build=build/fuzz
cmake --log-level=WARNING --preset fuzz
cmake --build --preset fuzz

real=${TAUT_REAL_DATA:-../shared/data}
seeds=$build/seeds
taut=$build/apps/taut/taut
# What HDF5 and oneTBB keep until the end is no leak of ours.
export ASAN_OPTIONS=detect_leaks=0

make_seeds() {
    local reader
    rm -rf $seeds
    for reader in "${readers[@]}"; do
        mkdir -p $seeds/"$reader" $build/corpus/"$reader"
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
    copy csv_survey $work/form.csv
    copy model $work/model.h5
    cat $work/net.csv $work/between $work/net_edges.csv >$work/pair.csv
    copy csv_net $work/pair.csv
    while IFS= read -r -d '' file; do
        copy compas "$file"
    done < <(find "$real" -name '*.json' -size -64k -print0 2>/dev/null)
}

copy() { # reader file
    [[ ! -d $seeds/$1 ]] || cp "$2" $seeds/"$1"/
}

make_seeds
status=0
for reader in "${readers[@]}"; do
    echo "fuzz: $reader for $seconds s"
    found=tests/fuzz/found/$reader
    [[ -d $found ]] || found=
    # A file that takes longer than 10 s, or more than 1 GiB, counts as found.
    if ! $build/tests/fuzz/fuzz_"$reader" $build/corpus/"$reader" $seeds/"$reader" $found \
        -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len=65536 \
        -print_final_stats=1 -verbosity=0 -artifact_prefix=$build/"$reader"- 2>$build/"$reader".log; then
        grep -E "ERROR|SUMMARY|Test unit written|what\(\)" $build/"$reader".log >&2 || tail -n 20 $build/"$reader".log >&2
        status=1
    fi
    grep -E "number_of_executed_units" $build/"$reader".log || true
done
exit $status
