#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Makes the Python environment build/venv/NAME out of scripts/requirements/NAME.txt, unless it is there
# with these versions.
# Usage: scripts/venv.sh build|docs|lint|test|uv
set -euo pipefail
cd "$(dirname "$0")/.."
name="$1"

is_current() { cmp --silent "scripts/requirements/$1.txt" "build/venv/$1/requirements.txt"; }
seal() { cp "scripts/requirements/$1.txt" "build/venv/$1/requirements.txt"; }

if ! is_current uv; then
    python3 -m venv --clear build/venv/uv
    build/venv/uv/bin/pip install --quiet --disable-pip-version-check -r scripts/requirements/uv.txt
    seal uv
fi
if ! is_current "$name"; then
    export UV_PYTHON_DOWNLOADS=never
    uv=build/venv/uv/bin/uv
    "$uv" venv --quiet --clear --python "$(command -v python3)" "build/venv/$name"
    "$uv" pip install --quiet --python "build/venv/$name/bin/python" -r "scripts/requirements/$name.txt"
    seal "$name"
fi
