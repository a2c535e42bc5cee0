#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds taut with the other compilers and the other standard library that it promises, and runs a
# program that is built with each: docs/compatibility.md. With libc++ that is taut::core: what taut::io
# needs comes from Debian as made for libstdc++.
# Usage: scripts/check_compilers.sh [14|16|libc++]...
set -euo pipefail
cd "$(dirname "$0")/.."

for name in "${@:-14}"; do
    compiler=clang++-$name
    flags=
    targets=all
    if [[ "$name" == libc++ ]]; then
        compiler=clang++-19
        flags=-stdlib=libc++
        targets=consumer_core
    fi
    build=build/compilers/$name
    echo "$("$compiler" --version | head -1) $flags"
    cmake --log-level=WARNING -S tests/consumer -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_CXX_FLAGS="$flags" -DTAUT_SOURCE_DIR="$PWD" -DREADME="$PWD/README.md"
    cmake --build "$build" --target "$targets"
    "$build/consumer_core"
    if [[ "$targets" == all ]]; then
        "$build/consumer" "$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
    fi
done
