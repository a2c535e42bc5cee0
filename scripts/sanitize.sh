#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds and runs the tests with the address and undefined behaviour sanitizers, by Clang. With --short
# those of most rooms: the others' take longest, and run much the same code many times over.
# Usage: scripts/sanitize.sh [--short]
set -euo pipefail
cd "$(dirname "$0")/.."

cmake --log-level=WARNING --preset asan
if [[ "${1:-}" != --short ]]; then
    cmake --build --preset asan
    ctest --preset asan
    exit
fi
rooms=(numerics net gp statics design survey estimation adjustment files interchange io results report)
cmake --build --preset asan --target "${rooms[@]/#/test_}"
ctest --preset asan --label-regex "^($(IFS='|'; echo "${rooms[*]}"))$"
