#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Installs the packages that the named groups need, of Debian 12 and 13 and Ubuntu 24.04, and nothing
# when all are there. On other systems it says what is needed and leaves it to CMake to look.
# cargo builds the conic solver Clarabel: Debian's cargo-web, kept up to date for browsers, is recent
# enough, its cargo is not. A cargo that is there, from rustup say, is left alone; where it is too old,
# CMake says so and builds without the solver.
# Usage: scripts/install_dependencies.sh [build|test|python|bench|lint|fuzz|hostile|compilers|browsers|reference|examples|windows|profile|ci]...
set -euo pipefail

# libboost-dev carries the headers of Boost.Math; libboost-math-dev only adds the compiled TR1
# functions. OpenBLAS comes with pthreads, since its serial form gives wrong numbers to threads that call
# it at once; HDF5 in its serial form.
build=(build-essential cmake ninja-build pkg-config libeigen3-dev libopenblas-dev
    libtbb-dev libnlopt-cxx-dev libhdf5-dev nlohmann-json3-dev libvalijson-dev libcli11-dev libfmt-dev libfast-float-dev libboost-dev libpugixml-dev
    libminizip-dev libmetis-dev libopenmpi-dev openmpi-bin)
test=(libgtest-dev libgmock-dev librapidcheck-dev python3-h5py python3-numpy chromium)
bench=(time libbenchmark-dev libmumps-seq-dev python3-sklearn python3-h5py python3-scipy python3-matplotlib)
lint=(clang-format-19 clang-tidy-19 python3-venv)
# libclang-rt holds libFuzzer and the sanitizers, llvm the names behind the addresses that they report.
fuzz=(clang-19 libclang-rt-19-dev llvm-19)
# Of tests/hostile: calls of the system are made to fail.
hostile=(python3-numpy strace)
reference=(doxygen)
# C#, which an example calls the library for C from.
examples=(mono-mcs mono-runtime)
# Of the rest pip takes care: pyproject.toml.
python=(python3-dev python3-venv python3-pip)
# Compilers that scripts/check_compilers.sh builds with.
compilers=(clang-14 clang-16 clang-19 libc++-19-dev libc++abi-19-dev)
# Besides Chromium, which the page for browsers works in.
browsers=(firefox-esr)
# For scripts/windows.sh; wine runs what that builds.
windows=(g++-mingw-w64-x86-64-posix wine wine64 unzip)
# For benchmarks/profiles.py; cargo builds inferno, which draws.
profile=(linux-perf gdb binutils)
# What earlier runs of .ci/run on this machine have compiled.
ci=(ccache)
cargo=cargo-web

system="$(. /etc/os-release 2>/dev/null && echo "$ID $VERSION_ID" || uname -s)"
case "$system" in
    "debian 12") ;;
    "debian 13")
        compilers=(clang-19 libc++-19-dev libc++abi-19-dev)  # it has none older than 17
        ;;
    "ubuntu 24.04")
        cargo=cargo
        test=("${test[@]/chromium/chromium-browser}")
        # It has no Clang 19, which these work with.
        for group in "$@"; do
            if [[ "$group" =~ ^(lint|fuzz|compilers|browsers)$ ]]; then
                echo "install_dependencies.sh: '$group' takes Debian, this is $system" >&2
                exit 1
            fi
        done
        ;;
    *)
        cat >&2 <<EOF
install_dependencies.sh: knows Debian 12 and 13 and Ubuntu 24.04, this is $system. taut needs:
  a compiler of C++20 (GCC 12, Clang 14), CMake 3.25, Ninja, pkg-config
  Eigen 3.4, oneTBB 2021, NLopt 2.7, BLAS and LAPACK (OpenBLAS), Boost 1.74, nlohmann-json 3.11, valijson 1.0,
  fmt 9, fast_float 3.9, HDF5 1.10, pugixml 1.13; for the program CLI11 2.1
  for Excel files minizip 1.1; for large nets METIS 5.1; for clusters MPI (Open MPI 4.1, MPICH 4.0)
  for plans and the cone program cargo 1.71; for reports Node.js 18 with npm
  for the tests GoogleTest 1.12, RapidCheck, Chromium, Python 3 with h5py and numpy
EOF
        exit 0
        ;;
esac

# The report's viewer is bundled by Node.js. One that is there already, from elsewhere too, will do.
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    build+=(nodejs npm)
fi
if ! command -v cargo >/dev/null && [[ ! -x "${CARGO_HOME:-$HOME/.cargo}/bin/cargo" ]]; then
    build+=("$cargo")
fi
test=("${build[@]}" "${test[@]}")
bench=("${build[@]}" "${bench[@]}")
lint=("${test[@]}" "${lint[@]}")
fuzz=("${build[@]}" "${fuzz[@]}")
hostile=("${build[@]}" "${hostile[@]}")

packages=()
groups=("${@:-build}")
for group in "${groups[@]}"; do
    case "$group" in
        build | test | python | bench | lint | fuzz | hostile | compilers | browsers | reference | examples | windows | profile | ci)
            declare -n members="$group"
            packages+=("${members[@]}")
            ;;
        *)
            echo "install_dependencies.sh: unknown group '$group'," \
                "expected build, test, python, bench, lint, fuzz, hostile, compilers, browsers, reference, examples, windows, profile or ci" >&2
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

# What taut builds and tests without: plans and the cone program, reports, the viewer's tests, a better
# order of elimination, and, unless it is to be tested, the program for clusters.
is_optional() {
    [[ "$1" =~ ^(cargo|cargo-web|nodejs|npm|chromium|chromium-browser|libmetis-dev)$ ]] ||
        [[ "$1" =~ openmpi && ! " ${groups[*]} " =~ " test " ]]
}

as_root=()
if ((EUID != 0)); then
    as_root=(sudo)
    if ! command -v sudo >/dev/null; then
        needed=()
        optional=()
        for package in "${missing[@]}"; do
            if is_optional "$package"; then optional+=("$package"); else needed+=("$package"); fi
        done
        {
            echo "install_dependencies.sh: this user may not install packages, and sudo is not there." \
                "An administrator can:"
            echo "  apt-get install --no-install-recommends ${missing[*]}"
            if ((${#optional[@]} > 0)); then
                echo "Optional of these: ${optional[*]} (cargo: plans and the cone program; nodejs, npm:" \
                    "reports; chromium: tests of the reports; libmetis-dev: large nets;" \
                    "libopenmpi-dev, openmpi-bin: taut-mpi)."
            fi
        } >&2
        if ((${#needed[@]} > 0)); then
            echo "install_dependencies.sh: without ${needed[*]} nothing can be built" >&2
            exit 1
        fi
        echo "install_dependencies.sh: going on without the optional ones" >&2
        exit 0
    fi
fi
echo "installing: ${missing[*]}"
"${as_root[@]}" apt-get update --quiet
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
