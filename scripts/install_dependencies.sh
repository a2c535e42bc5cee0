#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Installs the Debian 12 packages that the named groups need, and nothing when all are there.
# Usage: scripts/install_dependencies.sh [build|test|bench|lint]...
set -euo pipefail

# libboost-dev carries the headers of Boost.Math; libboost-math-dev only adds the compiled TR1
# functions. OpenBLAS comes with pthreads, HDF5 in its serial form.
build=(build-essential cmake ninja-build pkg-config libeigen3-dev libopenblas-dev liblapacke-dev
    libtbb-dev libhdf5-dev nlohmann-json3-dev libcli11-dev libfmt-dev libboost-dev)
test=("${build[@]}" libgtest-dev libgmock-dev librapidcheck-dev python3-h5py python3-numpy)
bench=("${build[@]}" libbenchmark-dev python3-sklearn python3-h5py python3-scipy)
lint=("${test[@]}" clang-format-19 clang-tidy-19)

packages=()
for group in "${@:-build}"; do
    case "$group" in
        build | test | bench | lint)
            declare -n members="$group"
            packages+=("${members[@]}")
            ;;
        *)
            echo "install_dependencies.sh: unknown group '$group', expected build, test, bench or lint" >&2
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
