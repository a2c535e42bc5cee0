#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Wheels of the Python package for other machines, in build/python/wheels, with all libraries in them and their
# licences. For Linux with glibc 2.28 or later (RHEL 8, Debian 10), one for each Python that there is here as python3.9,
# python3.10 and python3.11, and one for 3.12 and all later ones, where there is a python3.12 or later.
# Usage: scripts/wheels.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/cross.sh build/wheel
machine="$(uname -m)"
wheels="$PWD/build/python/wheels"

root() { # place
    copy_headers "$1/include"
    build_libraries "$1" metis nlopt onetbb
    rm -rf "$into/openblas"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --require-hashes --only-binary :all: \
        --platform "manylinux_2_28_$machine" -r scripts/requirements/wheel.txt -d "$into/openblas"
    unzip -q "$into"/openblas/*.whl -d "$into/openblas"
    cp "$into"/openblas/scipy_openblas32/lib/*.so "$1/lib"
    cp "$into"/openblas/*.dist-info/licenses/LICENSE.txt "$1/OpenBLAS.txt"
}

hdf5() { # place
    packaging/hdf5/build.sh "$1" "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=ON
}

prepare_zig
scripts/venv.sh build
root="$(place root < <(made_of && cat cmake/cross/zig.cmake scripts/requirements/wheel.txt))"
hdf5="$(place hdf5 < <(echo "$root" && cat packaging/hdf5/{build.sh,Cargo.lock}))"
toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/cross/zig.cmake" "-DTAUT_ZIG=$zig" "-DTAUT_CROSS_ROOT=$root"
    "-DTAUT_ZIG_TARGET=$machine-linux-gnu.2.28")
keep root "$root"
keep hdf5 "$hdf5"

settings=()
for define in "${toolchain[@]}" "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/cross/packages.cmake" \
    "-DTAUT_CARGO_TARGET=$machine-unknown-linux-gnu" -DTAUT_BUILD_VIEWER=ON -DTAUT_WITH_CLARABEL=ON -DTAUT_WITH_METIS=ON; do
    settings+=(-C "cmake.define.${define#-D}")
done
rm -rf "$wheels"
versions=()
for version in 3.9 3.10 3.11; do
    ! "python$version" --version &>/dev/null || versions+=("$version")
done
for version in 3.12 3.13 3.14; do
    if "python$version" --version &>/dev/null; then
        versions+=("$version")
        break
    fi
done
# By one CMake, so that the core is compiled once: the newest, which the last one needs.
last="${versions[-1]:?there is no Python here}"
scripts/venv.sh build "$last"
mkdir -p "$into/cmake"
rm -f "$into/cmake/cmake"
[[ ! -e build/venv/build-$last/bin/cmake ]] || ln -s "$PWD/build/venv/build-$last/bin/cmake" "$into/cmake"
for version in "${versions[@]}"; do
    scripts/venv.sh build "$version"
    tools="$PWD/build/venv/build-$version/bin"
    rm -rf "$into/dist"
    rm -f "$into/program/CMakeCache.txt"  # which knows another Python
    if ! PATH="$into/cmake:$PATH" PKG_CONFIG_LIBDIR="$hdf5/installed/lib/pkgconfig:$root/lib/pkgconfig" build/venv/uv/bin/uv build --wheel \
        --python "$tools/python" --no-build-isolation --out-dir "$into/dist" -C "build-dir=$into/program" \
        "${settings[@]}" &>"$into/build.log"; then
        cat "$into/build.log" >&2
        exit 1
    fi
    # Of one Python: that for 3.9 is older, and strips what is a script.
    LD_LIBRARY_PATH="$root/lib" PATH="$PWD/build/venv/build/bin:$PATH" \
        auditwheel repair --strip --wheel-dir "$wheels" "$into"/dist/taut-*.whl
done
for wheel in "$wheels"/*.whl; do
    build/venv/build/bin/python scripts/wheel_licences.py "$wheel" "$into/program" "$zig" "$root" "$hdf5"
done
ls -lh "$wheels"/*.whl
