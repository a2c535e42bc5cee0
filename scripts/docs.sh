#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the site of docs/ into build/site, with the reference of the C++ headers in it. Broken links and
# anchors fail. Takes the program at build/taut, and installs the Python package for its reference.
set -euo pipefail
cd "$(dirname "$0")/.."
into=build/docs
tools="$into/tools/bin"
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_QUIET=1

if ! [[ -x "$tools/mkdocs" && "$tools/mkdocs" -nt scripts/docs.sh ]]; then
    python3 -m venv --clear "$into/tools"
    "$tools/pip" install 'mkdocs-material>=9.5' 'mkdocstrings[python]>=0.27' mkdocs-jupyter ruff
    npm install --silent --no-audit --no-fund --prefix "$into" katex@0.16
    touch "$tools/mkdocs"
fi
# The package's reference is read from its sources and stubs, and its notebooks are run.
ls build/python/dist/taut-*.whl > /dev/null 2>&1 || scripts/python.sh build
wheel="$(ls build/python/dist/taut-*.whl)"
"$tools/pip" install "$wheel[compas,gp,pandas,plot]" ipykernel
"$tools/pip" install --no-deps --force-reinstall "$wheel"

PATH="$PWD/$tools:$PATH" NO_MKDOCS_2_WARNING=1 "$tools/mkdocs" build --strict
rm -rf build/site/cpp
cp -r build/reference build/site/cpp
echo "docs.sh: build/site/index.html"
