#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Makes the Python environment build/venv/NAME out of scripts/requirements/NAME.txt, unless it is there
# with these versions. uv reads UV_DEFAULT_INDEX and not pip's settings: PIP_INDEX_URL is handed on.
# Usage: scripts/venv.sh app|build|docs|lint|test|uv|wheel [VERSION]
#   VERSION   of Python, such as 3.9: makes build/venv/NAME-VERSION
set -euo pipefail
cd "$(dirname "$0")/.."
name="$1${2:+-$2}"
python="$(command -v "python${2:-3}")"
[[ -z "${PIP_INDEX_URL:-}" ]] || export UV_DEFAULT_INDEX="${UV_DEFAULT_INDEX:-$PIP_INDEX_URL}"

# By these versions and this Python.
wanted() { "$python" --version | cat - "scripts/requirements/${1%-*}.txt"; }
is_current() { cmp --silent <(wanted "$1") "build/venv/$1/made_of"; }
seal() { wanted "$1" >"build/venv/$1/made_of"; }

if ! is_current uv; then
    python3 -m venv --clear build/venv/uv
    build/venv/uv/bin/pip install --quiet --disable-pip-version-check -r scripts/requirements/uv.txt
    seal uv
fi
if ! is_current "$name"; then
    export UV_PYTHON_DOWNLOADS=never
    uv=build/venv/uv/bin/uv
    "$uv" venv --quiet --clear --python "$python" "build/venv/$name"
    "$uv" pip install --quiet --python "build/venv/$name/bin/python" -r "scripts/requirements/$1.txt"
    seal "$name"
fi
