#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Measures taut and, on the same data in the same run, its peers; puts the tables into docs/performance.md.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --log-level=WARNING --preset release -DTAUT_BUILD_BENCHMARKS=ON
cmake --build --preset release --target taut_app taut_benchmarks
ln -sfn release/apps/taut/taut build/taut
out=build/bench
rm -rf "$out"
mkdir -p "$out"

for name in statics learning; do
    build/release/benchmarks/bench_$name --benchmark_repetitions=3 \
        --benchmark_out="$out/$name.json" --benchmark_out_format=json
done
build/release/benchmarks/bench_factorisation --benchmark_filter='/(0|30|100)$' \
    --benchmark_repetitions=3 --benchmark_out="$out/factorisation.json" \
    --benchmark_out_format=json
# map_of_hypar/158, 50,000 edges, takes minutes: by hand.
build/release/benchmarks/bench_identification --benchmark_filter='^(balance|map)/|map_of_hypar/30' \
    --benchmark_repetitions=3 --benchmark_out="$out/identification.json" \
    --benchmark_out_format=json

build/release/benchmarks/bench_adjustment --benchmark_repetitions=3 \
    --benchmark_out="$out/adjustment.json" --benchmark_out_format=json

build/release/benchmarks/bench_threads --benchmark_repetitions=3 \
    --benchmark_out="$out/threads.json" --benchmark_out_format=json

build/release/benchmarks/bench_roofline --benchmark_repetitions=3 \
    --benchmark_out="$out/roofline.json" --benchmark_out_format=json
build/release/benchmarks/bench_growth --benchmark_out="$out/growth.json" \
    --benchmark_out_format=json
/usr/bin/python3 benchmarks/growth_figure.py "$out/growth.json" docs/images/growth.svg

build/release/benchmarks/bench_low_rank --benchmark_out="$out/low_rank.json" \
    --benchmark_out_format=json
/usr/bin/python3 benchmarks/memory.py build/taut "$out/memory.json"

# One plan with SciPy, from the same identified net.
build/taut example hilo-quarter -o "$out/net.json" > /dev/null
build/taut form "$out/net.json" --prior uniform:5mm --seed 1 -o "$out/site.csv" > /dev/null
build/taut survey "$out/net.json" "$out/site.csv" --noise 0.5mm --drop 10% -o "$out/site_survey.csv" > /dev/null
build/taut identify "$out/net.json" "$out/site_survey.csv" --draws 0 -o "$out/site.json" > /dev/null
build/taut export "$out/site.json" --to net -o "$out/identified.json" > /dev/null
/usr/bin/time -f '{"seconds": %e, "peak_kib": %M}' -o "$out/plan_process.json" \
    build/taut plan "$out/net.json" "$out/site.json" --tension 1.5kN..10kN -o "$out/plan.json" > /dev/null
/usr/bin/python3 benchmarks/peers/scipy_plan.py "$out/net.json" "$out/identified.json" 1500 10000 \
    > "$out/scipy_plan.json"

# The whole of reproduce, with its largest use of memory.
/usr/bin/time -f '{"seconds": %e, "peak_kib": %M}' -o "$out/reproduce_process.json" \
    build/taut reproduce -o "$out/reproduce" --keep --quiet --json > "$out/reproduce.json"

# A large net.
build/taut example hypar:300x300 -o "$out/hypar300.json" > /dev/null
/usr/bin/time -f '{"seconds": %e, "peak_kib": %M}' -o "$out/hypar300_process.json" \
    build/release/benchmarks/bench_statics --benchmark_filter=solve_hypar/300 > /dev/null

# Reports: the built-in net's, and that of a large net. Chromium opens them.
build/taut form "$out/hypar300.json" --prior uniform:1mm -o "$out/built.csv" > /dev/null
build/taut survey "$out/hypar300.json" "$out/built.csv" -o "$out/survey.csv" > /dev/null
/usr/bin/time -f '{"seconds": %e, "peak_kib": %M}' -o "$out/hypar300_identify_process.json" \
    build/taut identify "$out/hypar300.json" "$out/survey.csv" --prior uniform:1mm \
    -o "$out/hypar300_result.json" > /dev/null
build/taut report "$out/hypar300_result.json" -o "$out/hypar300.html" > /dev/null
[[ -d viewer/node_modules/playwright-core ]] ||
    (cd viewer && npm ci --ignore-scripts --no-audit --no-fund > /dev/null)
node viewer/tests/opening.mjs "$out/reproduce/report.html" "$out/hypar300.html" > "$out/opening.json"

# One output with scikit-learn, on the data set whose 536 outputs reproduce has just trained.
/usr/bin/python3 benchmarks/peers/sklearn_one_output.py "$out/reproduce/data.h5" \
    --training 950 --edge 0 > "$out/sklearn.json"

# The page for browsers, where it is built.
[[ ! -e build/app/taut.html ]] || /usr/bin/python3 benchmarks/app.py --write > /dev/null

/usr/bin/python3 benchmarks/performance_page.py "$out" --write > /dev/null
echo "written to docs/performance.md"
