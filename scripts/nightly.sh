#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# What .ci/run leaves out for time: every compiler and library that taut promises, all of clang-tidy, each
# public header and each source by itself, every test with the sanitizers, long fuzz and hostile runs.
# Takes hours' parts, not minutes. A release needs it (docs/releasing.md). At its end .ci/checked names the
# commit, which is to be committed: `make lint` looks at what has changed since.
# Usage: scripts/nightly.sh [SECONDS of fuzzing a reader]
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null
run_name=nightly
source scripts/steps.sh
seconds=${1:-120}

hostile=(/usr/bin/python3 tests/hostile/run.py --program build/taut)

step scripts/install_dependencies.sh test lint fuzz hostile compilers reference
step scripts/lint.sh --all
step make build
step cmake --log-level=WARNING --preset release -DTAUT_BUILD_TESTS=ON
step cmake --build --preset release
step cmake --build --preset release --target all_verify_interface_header_sets
step ctest --preset nightly
step scripts/check_compilers.sh libc++
step scripts/sanitize.sh
step make fuzz SECONDS="$seconds"
step "${hostile[@]}" --every-fault --seconds $((5 * seconds))
print_times
if [[ -z "$(git status --porcelain)" ]]; then
    git rev-parse HEAD >.ci/checked
    echo "nightly: .ci/checked names this commit: commit it"
fi
echo "nightly: all passed in $SECONDS s"
