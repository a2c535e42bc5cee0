#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the site of docs/ into build/site, with the reference of the C++ headers in it. Broken links and
# anchors fail. Takes the program at build/taut, and of scripts/python.sh the wheel, of which the sources
# and stubs are read for the reference, and the notebooks as its tests ran them. Where build/app/taut.html is there, it goes into the site.
set -euo pipefail
cd "$(dirname "$0")/.."
into=build/docs
tools="build/venv/docs/bin"

scripts/venv.sh docs
npm=scripts/requirements/docs-npm
if ! cmp --silent "$npm/package-lock.json" "$into/package-lock.json" || ! [[ -e "$into/node_modules/.package-lock.json" ]]; then
    mkdir -p "$into"
    cp "$npm/package.json" "$npm/package-lock.json" "$into"
    npm ci --silent --ignore-scripts --no-audit --no-fund --prefix "$into"
fi
for notebook in docs/notebooks/*.ipynb; do
    ran="build/python/notebooks/$(basename "$notebook")"
    if ! [[ "$ran" -nt "$notebook" ]]; then
        scripts/python.sh test -k notebook
        break
    fi
done
build/venv/uv/bin/uv pip install --quiet --python "$tools/python" --no-deps --reinstall build/python/dist/taut-*.whl

[[ -e build/app/taut.html ]] || echo "docs.sh: without the app: make app builds build/app/taut.html"
PATH="$PWD/$tools:$PATH" NO_MKDOCS_2_WARNING=1 "$tools/mkdocs" build --strict
if grep --recursive --include='*.html' --extended-regexp --max-count=1 \
    '<(script|iframe|img)[^>]* src="?https?:|<link[^>]* rel="?stylesheet[^>]* href="?https?:' build/site; then
    echo "docs.sh: these pages load what is not in the site" >&2
    exit 1
fi
rm -rf build/site/cpp
cp -r build/reference build/site/cpp
echo "docs.sh: build/site/index.html"
