#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the libraries with the other compilers that taut promises, and runs a program that is built with
# each: docs/compatibility.md.
# Usage: scripts/check_compilers.sh [14|16]...
set -euo pipefail
cd "$(dirname "$0")/.."

for version in "${@:-14}"; do
    compiler=clang++-$version
    build=build/compilers/clang-$version
    echo "$("$compiler" --version | head -1)"
    cmake --log-level=WARNING -S tests/consumer -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_UNITY_BUILD=ON -DTAUT_SOURCE_DIR="$PWD" -DREADME="$PWD/README.md"
    cmake --build "$build"
    "$build/consumer" "$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
done
