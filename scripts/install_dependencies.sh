#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Installs the Debian 12 packages that the named groups need, and nothing when all are there.
# cargo builds the conic solver Clarabel: Debian's cargo-web, kept up to date for browsers, is recent
# enough, its cargo is not. A cargo that is there, from rustup say, is left alone; where it is too old,
# CMake says so and builds without the solver.
# Usage: scripts/install_dependencies.sh [build|test|bench|lint|fuzz]...
set -euo pipefail

# libboost-dev carries the headers of Boost.Math; libboost-math-dev only adds the compiled TR1
# functions. OpenBLAS comes with pthreads, HDF5 in its serial form.
build=(build-essential cmake ninja-build pkg-config libeigen3-dev libopenblas-dev liblapacke-dev
    libtbb-dev libnlopt-cxx-dev libhdf5-dev nlohmann-json3-dev libcli11-dev libfmt-dev libboost-dev libpugixml-dev)
test=(libgtest-dev libgmock-dev librapidcheck-dev python3-h5py python3-numpy chromium)
bench=(time libbenchmark-dev libmumps-seq-dev python3-sklearn python3-h5py python3-scipy)
lint=(clang-format-19 clang-tidy-19)
# libclang-rt holds libFuzzer and the sanitizers, llvm the names behind the addresses that they tell.
fuzz=(clang-19 libclang-rt-19-dev llvm-19)

# The report's viewer is bundled by Node.js. One that is there already, from elsewhere too, will do.
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    build+=(nodejs npm)
fi
if ! command -v cargo >/dev/null && [[ ! -x "${CARGO_HOME:-$HOME/.cargo}/bin/cargo" ]]; then
    build+=(cargo-web)
fi
test=("${build[@]}" "${test[@]}")
bench=("${build[@]}" "${bench[@]}")
lint=("${test[@]}" "${lint[@]}")
fuzz=("${build[@]}" "${fuzz[@]}")

packages=()
for group in "${@:-build}"; do
    case "$group" in
        build | test | bench | lint | fuzz)
            declare -n members="$group"
            packages+=("${members[@]}")
            ;;
        *)
            echo "install_dependencies.sh: unknown group '$group', expected build, test, bench, lint or fuzz" >&2
            exit 2
            ;;
    esac
done

is_installed() {
    [[ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

missing=()
for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    as_root=(sudo)
fi
echo "installing: ${missing[*]}"
"${as_root[@]}" apt-get update --quiet
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
