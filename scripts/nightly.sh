#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# What .ci/run leaves out for time: every compiler and library that taut promises, all of clang-tidy, each
# public header and each source by itself, the app, every test with the sanitizers, long fuzz and hostile runs.
# A release needs it (CONTRIBUTING.md).
# Usage: scripts/nightly.sh [seconds of fuzzing a reader]
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
run_name=nightly
SECONDS=0  # make hands its own on
source scripts/steps.sh
seconds=${1:-120}
hostile=(/usr/bin/python3 tests/hostile/run.py --program build/taut)

step scripts/install_dependencies.sh test lint fuzz hostile compilers browsers reference python ci
step scripts/lint.sh --all
# The compiler of the consumers is looked for anew: .ci/run installs no Clang 14.
step cmake -U TAUT_OTHER_COMPILER --log-level=WARNING --preset release -DTAUT_BUILD_TESTS=ON
step make build
step cmake --build --preset release
step cmake --build --preset release --target all_verify_interface_header_sets
step ctest --preset nightly
step scripts/check_compilers.sh libc++
step scripts/sanitize.sh
step make app
step make windows
step env TAUT_PROGRAM="$PWD/build/taut" npm --prefix viewer run test:app
step make fuzz SECONDS="$seconds"
step "${hostile[@]}" --every-fault --seconds $((5 * seconds))
print_times
echo "nightly: all passed in $SECONDS s"
