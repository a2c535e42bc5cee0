#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# The Python package.
#   build   a wheel for this machine, in build/python/dist: out of build/release, where `make build`
#           and `make test` have built the libraries
#   test    a wheel for this machine, installed into an environment of its own, and its tests there;
#           the notebooks as they ran go into build/python/notebooks
#   lint    format and names of all Python sources, by ruff
# Usage: scripts/python.sh build|test|lint [argument of pytest]...
set -euo pipefail
cd "$(dirname "$0")/.."

task="${1:-}"
if [[ ! "$task" =~ ^(build|test|lint)$ ]]; then
    echo "python.sh: got '$task', expected build, test or lint" >&2
    exit 2
fi
shift
into=build/python
uv=build/venv/uv/bin/uv

if [[ "$task" == lint ]]; then
    scripts/venv.sh lint
    sources=(python tests/python tests/hostile integrations)
    build/venv/lint/bin/ruff format --diff --quiet "${sources[@]}" &&
        build/venv/lint/bin/ruff check --quiet "${sources[@]}"
    exit
fi

scripts/venv.sh build
tools="$PWD/build/venv/build/bin"

# build_wheel FOLDER [-C SETTING]...: into build/python/dist, built in FOLDER. What the compiler says is
# shown where it fails.
build_wheel() {
    rm -rf "$into/dist"
    mkdir -p "$into"
    if ! "$uv" build --wheel --python "$tools/python" --no-build-isolation --out-dir "$into/dist" \
        -C build-dir="$1" "${@:2}" >"$into/build.log" 2>&1; then
        cat "$into/build.log" >&2
        exit 1
    fi
}

# As `make build` does, so that what is built here need not be built again.
[[ -f build/release/build.ninja ]] ||
    cmake --log-level=WARNING --preset release -DTAUT_BUILD_TESTS=OFF
build_wheel build/release
if [[ "$task" == build ]]; then
    exit 0
fi

scripts/venv.sh test
fresh="$PWD/build/venv/test/bin"
wheel="$(ls "$PWD/$into"/dist/taut-*.whl)"
"$uv" pip install --quiet --python "$fresh/python" --reinstall-package taut \
    --constraint scripts/requirements/test.txt "taut[test] @ file://$wheel"
export TAUT_NOTEBOOKS="$PWD/$into/notebooks"
mkdir -p "$TAUT_NOTEBOOKS"
PATH="$fresh:$PATH" "$fresh/python" -m pytest -p no:cacheprovider --numprocesses 2 --dist worksteal tests/python "$@"
