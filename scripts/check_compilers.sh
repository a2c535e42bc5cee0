#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the libraries with the other compilers that taut promises, and runs a program that is built with
# each: docs/compatibility.md. With libc++ the core alone: packaged libraries of C++ are those of libstdc++.
# Usage: scripts/check_compilers.sh [14|16|19-libc++]...
set -euo pipefail
cd "$(dirname "$0")/.."

check() {
    local compiler=$1 name=$2 flags=$3 library=$4 program=$5
    local build=build/compilers/$name
    echo "$name: $("$compiler" --version | head -1)"
    cmake --log-level=WARNING -S tests/consumer -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_UNITY_BUILD=ON -DTAUT_SOURCE_DIR="$PWD" -DREADME="$PWD/README.md"
    cmake --build "$build" --target "$library" "$program"
    "$build/$program" "$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
}

for name in "${@:-14 16 19-libc++}"; do
    for each in $name; do
        case "$each" in
            14) check clang++-14 clang-14 "" taut_report consumer ;;
            16) check clang++-16 clang-16 "" taut_report consumer ;;
            19-libc++) check clang++-19 clang-19-libc++ "-stdlib=libc++" taut_core consumer_core ;;
            *)
                echo "check_compilers.sh: unknown compiler '$each', expected 14, 16 or 19-libc++" >&2
                exit 2
                ;;
        esac
    done
done
