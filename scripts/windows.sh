#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds taut for Windows 10 and later on 64 bit: build/windows/taut, the program with what it needs beside it. The
# compiler is Debian's MinGW-w64.
# Usage: scripts/windows.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/cross.sh build/windows

root() { # place
    copy_headers "$1/include"
    build_libraries "$1" nlopt onetbb
    rm -rf "$into/openblas"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --require-hashes --only-binary :all: \
        --platform win_amd64 -r scripts/requirements/wheel.txt -d "$into/openblas"
    unzip -q "$into"/openblas/*.whl -d "$into/openblas"
    mkdir -p "$1/bin"
    cp "$into"/openblas/scipy_openblas32/lib/*.dll "$1/bin"
    cp "$into"/openblas/scipy_openblas32/lib/*.lib "$1/lib"
    cp "$into"/openblas/*.dist-info/licenses/LICENSE.txt "$1/OpenBLAS.txt"
}

# For several threads it must be a shared library there.
hdf5() { # place
    packaging/hdf5/build.sh "$1" "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=ON -DBUILD_STATIC_LIBS=OFF -DBUILD_SHARED_LIBS=ON
    # It shows MinGW's threads, too, of which each program has its own.
    local imports="$1/installed/lib/libhdf5.dll.a"
    x86_64-w64-mingw32-nm --print-file-name "$imports" | sed -n 's/.*:\([^:]*\.o\):.* T [^H].*/\1/p' |
        xargs x86_64-w64-mingw32-ar d "$imports"
    sed -i 's/ -lm -lpthread//' "$1/installed/lib/pkgconfig/hdf5.pc"
}

scripts/venv.sh uv
root="$(place root < <(made_of && cat cmake/cross/mingw.cmake scripts/requirements/wheel.txt))"
hdf5="$(place hdf5 < <(echo "$root" && cat packaging/hdf5/{build.sh,Cargo.lock}))"
toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/cross/mingw.cmake" "-DTAUT_CROSS_ROOT=$root")
keep root "$root"
keep hdf5 "$hdf5"
find_rust
use_rust std,panic_unwind
PKG_CONFIG_LIBDIR="$hdf5/installed/lib/pkgconfig:$root/lib/pkgconfig" cmake --log-level=WARNING -S . -B "$into/program" \
    -G Ninja "${toolchain[@]}" "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/cross/packages.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 -DTAUT_BUILD_VIEWER=ON \
    -DTAUT_BUILD_TESTS=OFF -DTAUT_BUILD_EXAMPLES=OFF -DTAUT_BUILD_BENCHMARKS=OFF -DTAUT_BUILD_C=OFF -DTAUT_WITH_CLARABEL=ON \
    -DTAUT_CARGO_TARGET=x86_64-win7-windows-gnu
cmake --build "$into/program" --target taut_app
mkdir -p "$into/taut"
cp "$into/program/apps/taut/taut.exe" "$root"/bin/*.dll "$hdf5"/installed/bin/*.dll "$into/taut"
